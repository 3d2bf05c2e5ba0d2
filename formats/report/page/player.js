// player.js: the slider of a series, and playing it.

const frameMilliseconds = 120;

class Player {
  // go(frame)
  constructor(go) {
    this.go = go;
    this.slider = byId('slider');
    this.slider.max = frames.length - 1;
    this.button = byId('play');
    this.button.onclick = () => this.toggle();
    this.slider.oninput = () => {
      this.stop();
      go(Number(this.slider.value));
    };
    document.addEventListener('keydown', (event) => {
      const isFree = event.target === document.body || event.target === byId('marks');
      if (event.key !== ' ' || !isFree) return;
      event.preventDefault();
      this.toggle();
    });
    this.stop();
  }

  show(frame) {
    this.slider.value = frame;
    this.slider.setAttribute('aria-valuetext', `frame ${frame}, time ${frames[frame].report.time}`);
    byId('frame-label').textContent =
        `frame ${frame} of ${frames.length - 1} \u00b7 t = ${short(frames[frame].report.time, 5)}`;
  }

  toggle() {
    if (this.timer) {
      this.stop();
      return;
    }
    if (Number(this.slider.value) === frames.length - 1) this.go(0);
    this.timer = setInterval(() => {
      const next = Number(this.slider.value) + 1;
      if (next < frames.length) this.go(next);
      if (next >= frames.length - 1) this.stop();
    }, frameMilliseconds);
    this.label('\u275a\u275a', 'Pause');
  }

  stop() {
    clearInterval(this.timer);
    this.timer = undefined;
    this.label('\u25b6', 'Play');
  }

  label(sign, word) {
    this.button.textContent = sign;
    this.button.setAttribute('aria-label', word);
  }
}
