/** Which system's mouse buttons turn, pan and zoom. */
export const mouseStyles = ["Keiko", "Alias", "CATIA", "SolidWorks", "Blender"] as const;
export type MouseStyle = typeof mouseStyles[number];

export type MouseAction = "orbit" | "pan" | "zoom" | "lamps" | "section" | "none";

/** The part of a mouse event that an action depends on. */
export type MouseKeys = Pick<PointerEvent, "buttons" | "shiftKey" | "ctrlKey" | "metaKey" | "altKey">;

const left = 1, right = 2, middle = 4;

/** What a drag does. With Ctrl the left button drags the chosen row of lamps in every style, with Shift, too, the section. */
export function mouseAction(style: MouseStyle, event: MouseKeys): MouseAction {
  const { buttons, shiftKey, ctrlKey, metaKey, altKey } = event, hasControl = ctrlKey || metaKey;
  if (buttons === left && hasControl) return shiftKey ? "section" : "lamps";
  switch (style) {
    case "Keiko": return buttons & (right | middle) || shiftKey ? "pan" : "orbit";
    case "Alias": return !altKey || !shiftKey ? "none" : buttons & left ? "orbit" : buttons & middle ? "pan" : "zoom";
    case "CATIA":
      if (!(buttons & middle)) return "none";
      return buttons & (left | right) || hasControl ? "orbit" : shiftKey ? "zoom" : "pan";
    case "SolidWorks":
    case "Blender": {
      if (!(buttons & middle)) return "none";
      const pans = style === "Blender" ? shiftKey : hasControl, zooms = style === "Blender" ? hasControl : shiftKey;
      return pans ? "pan" : zooms ? "zoom" : "orbit";
    }
  }
}

/** One line on the buttons of a style. */
export const mouseHelp: Record<MouseStyle, string> = {
  Keiko: "drag turns, Shift or right button pans",
  Alias: "Shift + Alt: left turns, middle pans, right zooms",
  CATIA: "middle pans, middle with left, right or Ctrl turns, with Shift zooms",
  SolidWorks: "middle turns, with Ctrl pans, with Shift zooms",
  Blender: "middle turns, with Shift pans, with Ctrl zooms",
};
