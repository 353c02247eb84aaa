// Where each target went over the whole run: a line from each place where it appeared, with a dot there, to where it was last seen.

const STRENGTH = 0.5;
const DOT = 2.2; // pixels
const WIDTH = 0.9;

/** The tracks in a layer of their own: only what is new is drawn, however long they are. */
export class Tracks {
  constructor(run) {
    this.run = run;
    this.layer = document.createElement('canvas');
    this.drawn = 0;
  }

  paint(context, map, colour, unit) {
    const {canvas} = context;
    const {layer, run} = this;
    const transform = context.getTransform();
    if (map !== this.map || colour !== this.colour || run.count < this.drawn) {
      [layer.width, layer.height] = [canvas.width, canvas.height];
      Object.assign(this, {map, colour, drawn: 0});
    }
    const lines = layer.getContext('2d');
    lines.setTransform(transform);
    lines.strokeStyle = lines.fillStyle = colour;
    lines.lineWidth = WIDTH * unit;
    run.setup.targets.forEach((target, i) => this.draw(lines, map, i, DOT * unit));
    this.drawn = run.count;
    context.save();
    context.resetTransform();
    context.globalAlpha = STRENGTH;
    context.drawImage(layer, 0, 0);
    context.restore();
  }

  /** Adds a target's way since the last frame that is drawn; while it is away there is no line. */
  draw(lines, map, i, dot) {
    const [present, x, y] = [this.run.present[i], this.run.x[i], this.run.y[i]];
    lines.beginPath();
    for (let f = this.drawn; f < this.run.count; f++) {
      if (!present[f]) continue;
      if (f && present[f - 1]) {
        if (f === this.drawn) lines.moveTo(map.x(x[f - 1]), map.y(y[f - 1]));
        lines.lineTo(map.x(x[f]), map.y(y[f]));
      } else {
        lines.fillRect(map.x(x[f]) - dot, map.y(y[f]) - dot, 2 * dot, 2 * dot);
        lines.moveTo(map.x(x[f]), map.y(y[f]));
      }
    }
    lines.stroke();
  }
}
