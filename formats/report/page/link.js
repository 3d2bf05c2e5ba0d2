// link.js: the address tells frame, element, colours and view: "#frame=3&element=17". A copied address opens the same.

class Link {
  // read() gives what is shown, {frame, element, color, view}; show(wanted) shows what an address asks for.
  constructor(read, show) {
    this.read = read;
    this.show = show;
    const follow = () => {
      if (location.hash !== this.hash) this.follow();
    };
    addEventListener('popstate', follow);
    addEventListener('hashchange', follow);
  }

  // The address as an object; what it does not say is undefined.
  wanted() {
    const part = new URLSearchParams(location.hash.slice(1)), whole = (name) => {
      const text = part.get(name);
      return text !== null && /^\d{1,9}$/.test(text) ? Number(text) : undefined;
    };
    const view = (part.get('view') ?? '').split(',').map(Number);
    return {
      frame: whole('frame'),
      element: whole('element'),
      color: part.get('color') ?? undefined,
      view: view.length === 3 && view.every(Number.isFinite) && view[2] > 0 ? view : undefined
    };
  }

  follow() {
    this.isFollowing = true;
    this.hash = location.hash;
    this.show(this.wanted());
    this.isFollowing = false;
  }

  text() {
    const {frame, element, color, view} = this.read();
    const parts = [];
    if (frames.length > 1 || element !== undefined) parts.push(`frame=${frame}`);
    if (element !== undefined) parts.push(`element=${element}`);
    if (color !== undefined) parts.push(`color=${encodeURIComponent(color)}`);
    // The plus of an exponent would be read as a blank.
    if (view !== undefined) parts.push(`view=${view.join().replaceAll('+', '')}`);
    return parts.length > 0 ? `#${parts.join('&')}` : '#';
  }

  // A step that "back" undoes: another element or frame.
  step() {
    this.write('pushState');
  }
  // What is no step of its own: moving, playing. Browsers limit how often an address may change.
  soon() {
    if (this.isFollowing) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.write('replaceState'), 250);
  }

  write(how) {
    if (this.isFollowing) return;
    clearTimeout(this.timer);
    const text = this.text();
    if (text === (location.hash || '#')) return;
    window.history[how](null, '', text);
    this.hash = location.hash;
  }
}
