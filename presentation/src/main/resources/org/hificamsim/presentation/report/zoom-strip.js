// Shows the zoom level of each camera over time, with one row for each camera.
import {el, style} from './dom.js';
import {decimals} from './numbers.js';
import {levelShare, scaleColour} from './palette.js';
import {Strip} from './strip.js';
import {viewName, viewOf} from './views.js';

export class ZoomStrip extends Strip {
  constructor(playhead, handlers) {
    const label = 'zoom level of each camera over time';
    super(playhead, {title: 'zoom of each camera', label, name: 'cameras'}, key());
    this.handlers = handlers;
    this.box.addEventListener('click', event => this.handlers.select(this.rowAt(event)));
  }

  namesOf({cameras}) {
    return cameras.map((camera, i) =>
      el(
        'button',
        {
          type: 'button',
          title: camera.name,
          'aria-pressed': 'false',
          onclick: () => this.handlers.select(i),
        },
        camera.name,
      ),
    );
  }

  select(camera) {
    [...this.rows.children].forEach((row, i) =>
      row.setAttribute('aria-pressed', String(i === camera)),
    );
  }

  describe(camera, frame) {
    const view = this.run.level[camera][frame];
    const pose = this.run.pose(camera, frame);
    const {zoom, viewingAngle} = viewOf(pose, view);
    const extent = pose.lenses
      ? `${decimals((viewingAngle * 180) / Math.PI, 1)}° wide`
      : `radius ${decimals(pose.levels[zoom].radius, 3)} m`;
    const text = this.run.online[camera][frame]
      ? `${viewName(pose, view)}, ${extent}, detects ${this.run.detected[camera][frame]}`
      : 'not online';
    return `${this.run.setup.cameras[camera].name}, step ${this.run.step[frame]}: ${text}`;
  }

  /** Paints the levels; a column of pixels shows the mean level of its frames. */
  paint(context, width, height) {
    const {run} = this;
    const cameras = run.setup.cameras.length;
    if (!cameras) return;
    const columns = this.surface.canvas.width;
    const image = new ImageData(columns, cameras);
    const first = run.step[0];
    const perColumn = (run.step[run.count - 1] - first + 1) / columns;
    for (let column = 0; column < columns; column++) {
      const from = run.frameAt(first + column * perColumn);
      const to = Math.max(from, run.frameAt(first + (column + 1) * perColumn - 1e-9));
      for (let camera = 0; camera < cameras; camera++) {
        paintCell(image, column, camera, meanLevel(run, camera, from, to));
      }
    }
    const rows = document.createElement('canvas');
    [rows.width, rows.height] = [columns, cameras];
    rows.getContext('2d').putImageData(image, 0, 0);
    context.imageSmoothingEnabled = false;
    context.drawImage(rows, 0, 0, width, height);
    context.fillStyle = style('--paper');
    for (let camera = 1; camera < cameras; camera++)
      context.fillRect(0, (camera * height) / cameras - 0.5, width, 1);
  }
}

/** The mean level on a scale from 0, the narrowest, to 1, the widest; NaN if never online. */
function meanLevel(run, camera, from, to) {
  const levels = run.level[camera];
  const most = run.setup.cameras[camera].pose.levels.length;
  let sum = 0;
  let count = 0;
  for (let frame = from; frame <= to; frame++) {
    if (!run.online[camera][frame]) continue;
    sum += levelShare(levels[frame] % most, most);
    count++;
  }
  return sum / count;
}

function paintCell(image, column, row, share) {
  if (Number.isNaN(share)) return;
  image.data.set([...scaleColour(share), 255], 4 * (row * image.width + column));
}

function key() {
  const stops = [0, 0.25, 0.5, 0.75, 1].map(share => {
    const swatch = el('i', {class: 'swatch'});
    swatch.style.background = `rgb(${scaleColour(share).join()})`;
    return swatch;
  });
  return el('span', {class: 'key'}, 'narrow', ...stops, 'wide');
}
