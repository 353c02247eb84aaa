// Play, step, scrub and speed: buttons, a slider and keys for one playhead.
import { el, say } from './dom.js';
import { SPEEDS } from './playhead.js';

const KEYS = 'Keys: space plays and pauses, arrows step (with shift by 10), Home and End jump, + and - change the speed.';

export class Controls {
  /**
   * @param run whose steps the playhead's frames are
   */
  constructor(playhead, run) {
    this.playhead = playhead;
    this.run = run;
    this.playButton = this.button('▶', 'play', () => playhead.toggle());
    this.playButton.classList.add('play');
    this.slider = el('input', {type: 'range', min: 0, max: 0, step: 1, value: 0, 'aria-label': 'step',
      oninput: () => { playhead.pause(); playhead.show(Number(this.slider.value)); }});
    this.step = el('output', {class: 'step', data: {name: 'step'}});
    this.of = el('span', {class: 'of'});
    this.speed = el('select', {'aria-label': 'steps per second', onchange: () => this.setSpeed()},
      ...SPEEDS.map(speed => el('option', {value: speed}, `${speed} per s`)));
    this.element = el('section', {class: 'controls', 'aria-label': 'playing', title: KEYS},
      this.button('⏮', 'first step', () => playhead.move(-Infinity)),
      this.button('◀', 'one step back', () => playhead.move(-1)),
      this.playButton,
      this.button('▶▏', 'one step on', () => playhead.move(1)),
      this.button('⏭', 'last step', () => playhead.move(Infinity)),
      this.slider, el('span', {class: 'count'}, 'step ', this.step, this.of), this.speed);
    playhead.subscribe(frame => this.show(frame));
  }

  button(text, label, onclick) {
    return el('button', {type: 'button', 'aria-label': label, title: label, onclick}, text);
  }

  setSpeed() {
    this.playhead.speed = Number(this.speed.value);
    this.playhead.tell();
  }

  show(frame) {
    const {playhead, run} = this;
    const step = run.count ? run.step[frame] : 0;
    this.slider.max = String(Math.max(0, playhead.count - 1));
    this.slider.value = String(frame);
    this.slider.setAttribute('aria-valuetext', `step ${step}`);
    say(this.step, String(step));
    say(this.of, ` of ${Math.max(0, run.steps - 1)}`);
    say(this.playButton, playhead.playing ? '⏸' : '▶');
    this.playButton.setAttribute('aria-label', playhead.playing ? 'pause' : 'play');
    this.speed.value = String(playhead.speed);
  }

  /** Keys anywhere on the page, but for those that a focused control has its own use for. */
  listen() {
    document.addEventListener('keydown', event => {
      const tag = event.target.tagName;
      if (event.ctrlKey || event.altKey || event.metaKey || tag === 'SELECT' || tag === 'TEXTAREA') return;
      if (tag === 'INPUT' && event.target !== this.slider) return;
      if (event.key === ' ' && (tag === 'BUTTON' || tag === 'SUMMARY')) return;
      const action = this.action(event);
      if (!action) return;
      action();
      event.preventDefault();
    });
  }

  action({key, shiftKey}) {
    const {playhead} = this;
    const by = shiftKey ? 10 : 1;
    return {
      ' ': () => playhead.toggle(),
      ArrowRight: () => playhead.move(by),
      ArrowLeft: () => playhead.move(-by),
      Home: () => playhead.move(-Infinity),
      End: () => playhead.move(Infinity),
      '+': () => playhead.faster(1),
      '=': () => playhead.faster(1),
      '-': () => playhead.faster(-1),
    }[key];
  }
}
