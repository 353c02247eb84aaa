// Keeps the tracks of a run on a canvas of their own, so that only new frames have to be drawn.
import {paintTracks} from './path-layers.js';

export class TrackCanvas {
  constructor() {
    this.canvas = document.createElement('canvas');
    this.frames = 0; // drawn so far
  }

  /** Paints the tracks of a scene on the field's canvas, after drawing the new frames. */
  paint(context, scene) {
    const {canvas} = this;
    const own = canvas.getContext('2d');
    const {run, map, colours} = scene;
    if (map !== this.map || colours !== this.colours || run.count < this.frames) {
      [canvas.width, canvas.height] = [context.canvas.width, context.canvas.height];
      own.setTransform(context.getTransform());
      this.frames = 0;
    }
    paintTracks(own, scene, this.frames);
    [this.map, this.colours, this.frames] = [map, colours, run.count];
    context.resetTransform();
    context.drawImage(canvas, 0, 0);
  }
}
