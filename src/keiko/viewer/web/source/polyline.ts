/** A point of a picture, px. */
export type Point = [number, number];

/** Draws a line through points, with a gap where one is beside or behind the eye. */
export function stroke(context: CanvasRenderingContext2D, points: (Point | null)[]): void {
  context.beginPath();
  let isDown = false;
  for (const point of points) {
    if (point && isDown) context.lineTo(...point);
    else if (point) context.moveTo(...point);
    isDown = point !== null;
  }
  context.stroke();
}
