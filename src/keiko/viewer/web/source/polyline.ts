/** A point of a picture, px. */
export type Point = [number, number];

/** Draws a line through points, with a gap where one is beside or behind the eye. */
export function stroke(context: CanvasRenderingContext2D, points: (Point | null)[]): void {
  context.beginPath();
  follow(context, points);
  context.stroke();
}

/** Draws many lines at once. */
export function strokeAll(context: CanvasRenderingContext2D, lines: (Point | null)[][], color: string, width: number): void {
  Object.assign(context, { strokeStyle: color, lineWidth: width });
  context.beginPath();
  for (const line of lines) follow(context, line);
  context.stroke();
}

function follow(context: CanvasRenderingContext2D, points: (Point | null)[]): void {
  let isDown = false;
  for (const point of points) {
    if (point && isDown) context.lineTo(...point);
    else if (point) context.moveTo(...point);
    isDown = point !== null;
  }
}
