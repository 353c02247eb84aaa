// The layers of cooperation: what a camera believes, and the messages that it sends. Rhino runs
// this file too: see scene.js.
import {PARTS_PER_SIDE, partsOffset, sentMessages, TARGET_NUMBERS} from './belief.js';
import {poseAt} from './views.js';

/**
 * Shades the parts of the field where unseen targets are expected, and draws a circle with a cross
 * for each target that was seen. The less certain the camera is of a target, the paler its circle.
 */
export function beliefs(context, {belief, run, map, colours, unit}) {
  if (!belief) return;
  const {minX, maxX, minY, maxY} = run.setup.field;
  const [width, height] = [
    (map.scale * (maxX - minX)) / PARTS_PER_SIDE,
    (map.scale * (maxY - minY)) / PARTS_PER_SIDE,
  ];
  const first = partsOffset(run);
  const end = first + PARTS_PER_SIDE * PARTS_PER_SIDE;
  let most = 1e-9;
  for (let i = first; i < end; i++) most = Math.max(most, belief[i]);
  context.fillStyle = context.strokeStyle = colours.accent;
  for (let i = first; i < end; i++) {
    let [row, column] = [Math.floor((i - first) / PARTS_PER_SIDE), (i - first) % PARTS_PER_SIDE];
    context.globalAlpha = (0.5 * belief[i]) / most;
    context.fillRect(map.x(minX) + column * width, map.y(minY) - (row + 1) * height, width, height);
  }
  context.lineWidth = 1.5 * unit;
  for (let i = 0; i < first; i += TARGET_NUMBERS) {
    let [x, y, radius] = [
      map.x(belief[i]),
      map.y(belief[i + 1]),
      7 * unit + map.scale * belief[i + 3],
    ];
    if (!(belief[i + 2] > 0)) continue;
    context.globalAlpha = 0.25 + 0.75 * belief[i + 2];
    context.beginPath();
    context.moveTo(x + radius, y);
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.moveTo(x - 4 * unit, y);
    context.lineTo(x + 4 * unit, y);
    context.moveTo(x, y - 4 * unit);
    context.lineTo(x, y + 4 * unit);
    context.stroke();
  }
}

/**
 * Draws an arrow from the selected camera to each camera that received its message in this step.
 */
export function messages(context, scene) {
  const {belief, run, frame, map, colours, unit, selected} = scene;
  const sent = belief && selected >= 0 && sentMessages(run, frame, selected);
  if (!sent) return;
  const from = poseAt(run, selected, frame);
  context.strokeStyle = colours.accent;
  context.lineWidth = 1.2 * unit;
  context.beginPath();
  sent.receivers.forEach(receiver => {
    const to = poseAt(run, receiver, frame);
    const [x, y] = [map.x(to.x), map.y(to.y)];
    const angle = Math.atan2(y - map.y(from.y), x - map.x(from.x));
    const [tipX, tipY] = [x - 9 * unit * Math.cos(angle), y - 9 * unit * Math.sin(angle)];
    context.moveTo(map.x(from.x), map.y(from.y));
    context.lineTo(tipX, tipY);
    [angle + 2.6, angle - 2.6].forEach(barb => {
      context.moveTo(tipX, tipY);
      context.lineTo(tipX + 9 * unit * Math.cos(barb), tipY + 9 * unit * Math.sin(barb));
    });
  });
  context.stroke();
}
