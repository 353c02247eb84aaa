// The parts that show one run: the field, its numbers, the selected camera, and charts over time.
import {el} from './dom.js';
import {FieldView} from './field.js';
import {Readout} from './readout.js';
import {AgentPanel} from './agent.js';
import {Timeline} from './timeline.js';
import {TargetForm} from './target-form.js';

export class Player {
  /**
   * @param run recorded or growing
   * @param playhead may be shared with other players
   * @param options `middle`: an element between the field and the timeline;
   *   `edit`: what can be done to cameras, as {@link PoseForm} and {@link ViewTable} say;
   *   `draw`: the {@link DrawForm}, if the site can be drawn; `tools`: elements beside the field;
   *   `heat(figure)` when one of `figures` of the heat map is chosen, if there can be a heat map;
   *   `ceiling()`: the value that the axis of k_min reaches at least
   */
  constructor(run, playhead, options = {}) {
    this.run = run;
    this.playhead = playhead;
    const {edit} = options;
    const on = {
      select: camera => this.select(camera),
      drag: edit && ((camera, x, y) => edit.move(camera, x, y)),
      ceiling: options.ceiling,
      objective: run.objective,
      following: run.setup.following,
      pick: target => this.targets?.choose(target),
      heat: options.heat,
      figures: options.figures,
      line: places => options.draw.complete(places),
      drawing: places => options.draw.show(places),
    };
    this.field = new FieldView(run, on);
    this.readout = new Readout(run);
    this.agent = new AgentPanel(run, options.edit);
    this.timeline = new Timeline(playhead, on);
    this.targets = edit && new TargetForm(run.setup, edit);
    this.agent.element.hidden = !run.setup.cameras.length;
    const tools = [...(options.tools ?? []), this.targets?.element].filter(Boolean);
    this.element = el(
      'div',
      {class: 'player'},
      this.field.element,
      el(
        'div',
        {class: 'side'},
        this.readout.element,
        this.agent.element,
        tools.length ? el('section', {class: 'tools', 'aria-label': 'the site'}, ...tools) : null,
      ),
      options.middle,
      this.timeline.element,
    );
    this.timeline.load(run);
    if (run.setup.cameras.length) this.select(run.busiest());
    playhead.subscribe(frame => this.show(frame));
  }

  /** Selects a camera in all parts; -1, a click that hit no camera, changes nothing. */
  select(camera) {
    if (camera < 0) return;
    this.field.set('selected', camera);
    this.agent.select(camera);
    this.timeline.select(camera);
  }

  /** Shows frames that were added to the run. */
  grew() {
    this.timeline.load(this.run);
    this.show(this.playhead.frame);
  }

  show(frame) {
    if (frame >= this.run.count) return;
    this.field.show(frame);
    this.readout.show(frame);
    this.agent.show(frame);
    this.timeline.show(frame);
  }
}
