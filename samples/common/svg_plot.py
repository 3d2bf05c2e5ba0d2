"""svg_plot: plots of histories as SVG, panels below one another that share the time axis."""
import math
from html import escape

WIDTH, LEFT, RIGHT, TOP = 900, 74, 96, 64
PANEL, GAP = 118, 46
INK, SOFT, GRID = "#14232e", "#5c6770", "#e4e8ec"
LINES = ["#3b6fb0", "#d9692e", "#3f9463", "#b8486a", "#7461b5", "#b8922a"]


def nice_step(span, count):
    """A round number of which about `count` fit into the span."""
    rough = span / count if span > 0 else 1
    power = 10.0 ** math.floor(math.log10(rough))
    return next(step * power for step in (1, 2, 5, 10) if step * power >= rough * 0.999)


def label(value, step):
    if value == 0:
        return "0"
    if abs(value) >= 1e4 or step < 1e-3:
        mantissa, exponent = f"{value:.1e}".split("e")
        mantissa = mantissa.removesuffix(".0").replace("-", "−")
        power = "".join("⁰¹²³⁴⁵⁶⁷⁸⁹"[int(digit)] if digit != "-" else "⁻" for digit in str(int(exponent)))
        return f"{mantissa}·10{power}"
    decimals = max(0, -math.floor(math.log10(step) + 1e-9))
    return f"{value:.{decimals}f}".replace("-", "−")


class Plot:
    """Panels below one another that share the time axis."""

    def __init__(self, times, panels):
        self.parts = []
        self.low, self.high = times[0], times[-1] if times[-1] > times[0] else times[0] + 1
        self.height = TOP + panels * (PANEL + GAP) + 14
        self.top = TOP

    def x(self, time):
        return LEFT + (time - self.low) / (self.high - self.low) * (WIDTH - LEFT - RIGHT)

    def text(self, x, y, words, more=""):
        self.parts.append(f'<text x="{x:.1f}" y="{y:.1f}"{more}>{escape(words)}</text>')

    def panel(self, title, values, from_zero=True):
        """Opens a panel whose axis holds the values; returns the map from a value to its height in the picture."""
        low, high = min(values), max(values)
        if from_zero:
            low, high = min(low, 0), max(high, 0)
        if low == high:
            high = low + 1
        step = nice_step(high - low, 3)
        low, high = math.floor(low / step + 1e-9) * step, math.ceil(high / step - 1e-9) * step
        top = self.top

        def y(value):
            return top + PANEL * (high - value) / (high - low)

        self.text(LEFT, top - 10, title, f' font-weight="600" fill="{INK}"')
        for k in range(round((high - low) / step) + 1):
            value = low + k * step
            value = 0 if abs(value) < step / 1e6 else value
            self.parts.append(f'<path stroke="{SOFT if value == 0 else GRID}" d="M{LEFT} {y(value):.1f}H{WIDTH - RIGHT}"/>')
            self.text(LEFT - 8, y(value) + 4, label(value, step), ' text-anchor="end"')
        self.top += PANEL + GAP
        return y

    def time_axis(self, with_label):
        bottom = self.top - GAP
        step = nice_step(self.high - self.low, 8)
        k = math.ceil(self.low / step - 1e-9)
        while k * step <= self.high + 1e-9 * step:
            x = self.x(k * step)
            self.parts.append(f'<path stroke="{SOFT}" d="M{x:.1f} {bottom:.1f}v4"/>')
            if with_label:
                self.text(x, bottom + 17, label(k * step, step), ' text-anchor="middle"')
            k += 1
        if with_label:
            self.text((LEFT + WIDTH - RIGHT) / 2, bottom + 36, "time", ' text-anchor="middle"')

    def line(self, times, values, y, color):
        points = " ".join(f"{self.x(t):.1f},{y(v):.1f}" for t, v in zip(times, values))
        self.parts.append(f'<polyline fill="none" stroke="{color}" stroke-width="1.6" stroke-linejoin="round" points="{points}"/>')

    def bars(self, times, values, y, color):
        width = max(1.0, 0.7 * (self.x(self.high) - self.x(self.low)) / max(1, len(times)))
        data = "".join(f"M{self.x(t):.1f} {y(0):.1f}V{y(v):.1f}" for t, v in zip(times, values) if v)
        self.parts.append(f'<path stroke="{color}" stroke-width="{width:.2f}" d="{data or "M0 0"}"/>')

    def names(self, entries):
        """Names beside the panel's right end, moved apart: (height, name, color)."""
        last = -math.inf
        for y, name, color in sorted(entries):
            last = max(y + 4, last + 14)
            self.text(WIDTH - RIGHT + 8, last, name, f' fill="{color}" font-weight="600"')

    def write(self, path, title, subtitle):
        with open(path, "w") as out:
            out.write(f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{self.height}" '
                      f'viewBox="0 0 {WIDTH} {self.height}" font-size="12" fill="{SOFT}" font-family="system-ui, '
                      "'Segoe UI', Roboto, 'DejaVu Sans', Helvetica, Arial, sans-serif\">\n"
                      '<rect width="100%" height="100%" fill="#fff"/>\n'
                      f'<text x="{LEFT}" y="22" font-size="15" font-weight="600" fill="{INK}">{escape(title)}</text>\n'
                      f'<text x="{WIDTH - RIGHT}" y="22" text-anchor="end">{escape(subtitle)}</text>\n')
            out.write("\n".join(self.parts) + "\n</svg>\n")
