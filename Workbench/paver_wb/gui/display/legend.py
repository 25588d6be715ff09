"""The colour bar: scale with units and histogram, or a list of colours with counts; and the report of an element."""
from PySide import QtCore, QtGui

from paver_wb import statistics
from paver_wb.gui.display import colouring, report
from paver_wb.gui.display.colouring import translate
from paver_wb.gui.display.panels import FAINT, INK, font, sheet, text_size

PAD, BAR_HEIGHT, BAR_WIDTH, HISTOGRAM_WIDTH = 10, 190, 18, 86
TICKS = 6
ROW = 18


def number(value):
    """As short as it can be told from its neighbours on a scale."""
    return f"{value:.3g}".replace("e-0", "e-").replace("e+0", "e")


def ticks(scale):
    """(value, label) from low to high."""
    step = (scale.high - scale.low) / (TICKS - 1)
    return [(scale.low + i * step, number(scale.low + i * step)) for i in range(TICKS)]


def heading(scale):
    return [scale.title] + ([scale.unit] if scale.unit else [])


def summary(scale):
    names = translate("Paver", "min"), translate("Paver", "mean"), translate("Paver", "max")
    figures = (number(x) for x in (scale.least, scale.mean, scale.most))
    return ["   ".join(f"{name} {figure}" for name, figure in zip(names, figures)),
            report.elements_text(int(scale.histogram.sum()))]


def key_rows(key):
    """(label, count, colour); the last one says how many more there are."""
    rows = [(label, statistics.number(count), colour) for label, colour, count in key.entries]
    if len(rows) <= colouring.MOST_ENTRIES:
        return rows
    kept = colouring.MOST_ENTRIES - 1
    hidden = sum(count for _, _, count in key.entries[kept:])
    more = translate("Paver", "{} more").format(len(rows) - kept)
    return rows[:kept] + [(more, statistics.number(hidden), None)]


def picture(legend, label=""):
    """QImage of a Scale or a Key; label: the mesh that it is of, where there are others."""
    if label:
        legend = legend._replace(title=f"{label}: {legend.title}")
    return (picture_of_scale if isinstance(legend, colouring.Scale) else picture_of_key)(legend)


def ink(painter, colour=INK, **style):
    painter.setPen(QtGui.QColor(*colour))
    painter.setFont(font(**style))


def picture_of_scale(scale):
    lines, below = heading(scale), summary(scale)
    texts = [text for _, text in ticks(scale)]
    left = PAD + widest(texts) + 8
    widths = [text_size(lines[0], font(10, True)).width()] + [text_size(x, font(8)).width() for x in lines[1:] + below]
    width = max(left + BAR_WIDTH + HISTOGRAM_WIDTH + PAD, max(widths) + 2 * PAD)
    top = PAD + ROW * len(lines) + 10
    image, painter = sheet(width, top + BAR_HEIGHT + 10 + 15 * len(below) + PAD)
    paint_lines(painter, lines, below, top)
    paint_bar(painter, scale, left, top)
    paint_histogram(painter, scale, left + BAR_WIDTH + 3, top)
    ink(painter)
    for i, text in enumerate(texts):
        y = top + BAR_HEIGHT * (1 - i / (TICKS - 1))
        painter.drawLine(QtCore.QPointF(left - 4, y), QtCore.QPointF(left, y))
        painter.drawText(QtCore.QRectF(0, y - 10, left - 7, 20), QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter, text)
    painter.end()
    return image


def paint_lines(painter, lines, below, top):
    ink(painter, size=10, bold=True)
    painter.drawText(QtCore.QRectF(PAD, PAD, 600, ROW), QtCore.Qt.AlignLeft, lines[0])
    ink(painter, FAINT, size=8)
    for i, text in enumerate(lines[1:], 1):
        painter.drawText(QtCore.QRectF(PAD, PAD + ROW * i, 600, ROW), QtCore.Qt.AlignLeft, text)
    for i, text in enumerate(below):
        painter.drawText(QtCore.QRectF(PAD, top + BAR_HEIGHT + 12 + 15 * i, 600, 15), QtCore.Qt.AlignLeft, text)


def paint_bar(painter, scale, left, top):
    painter.setRenderHint(QtGui.QPainter.Antialiasing, False)
    for row in range(BAR_HEIGHT):
        colour = scale.table[min(int((1 - row / BAR_HEIGHT) * len(scale.table)), len(scale.table) - 1)]
        painter.fillRect(left, top + row, BAR_WIDTH, 1, QtGui.QColor.fromRgbF(*(float(c) for c in colour)))
    painter.setRenderHint(QtGui.QPainter.Antialiasing)


def paint_histogram(painter, scale, left, top):
    """Bars as long as the share of elements; an element alone can be seen too."""
    most, step = max(int(scale.histogram.max()), 1), BAR_HEIGHT / len(scale.histogram)
    painter.setPen(QtCore.Qt.NoPen)
    painter.setBrush(QtGui.QColor(120, 126, 135, 190))
    for i, count in enumerate(scale.histogram):
        if count:
            length = max(2.0, (HISTOGRAM_WIDTH - 6) * float(count) / most)
            painter.drawRect(QtCore.QRectF(left, top + BAR_HEIGHT - (i + 1) * step + 0.5, length, step - 1))


def widest(texts):
    return max((text_size(text, font()).width() for text in texts), default=0)


def titled_sheet(title, width, height):
    """(image, painter, its width) of a sheet with a title, and room for so much below it."""
    width = max(width, text_size(title, font(10, True)).width()) + 2 * PAD
    image, painter = sheet(width, PAD + ROW + height + PAD - 4)
    ink(painter, size=10, bold=True)
    painter.drawText(QtCore.QRectF(PAD, PAD, width, ROW), QtCore.Qt.AlignLeft, title)
    return image, painter, width


def picture_of_key(key):
    rows = key_rows(key)
    names, counts = widest(label for label, _, _ in rows), widest(count for _, count, _ in rows)
    image, painter, width = titled_sheet(key.title, 22 + names + 16 + counts, 6 + ROW * len(rows))
    for i, (label, count, colour) in enumerate(rows):
        y = PAD + ROW + 6 + i * ROW
        if colour is not None:
            painter.setPen(QtGui.QColor(0, 0, 0, 90))
            painter.setBrush(QtGui.QColor.fromRgbF(*(float(c) for c in colour)))
            painter.drawRect(QtCore.QRectF(PAD + 0.5, y + 3.5, 13, 11))
        ink(painter, INK if colour is not None else FAINT)
        painter.drawText(QtCore.QRectF(PAD + 22, y, names + 4, ROW), QtCore.Qt.AlignVCenter, label)
        ink(painter, FAINT)
        painter.drawText(QtCore.QRectF(0, y, width - PAD, ROW), QtCore.Qt.AlignRight | QtCore.Qt.AlignVCenter, count)
    painter.end()
    return image


def picture_of_report(rows):
    """QImage of (name, value) rows; the first one is the heading."""
    (title, _), rows = rows[0], rows[1:]
    names, values = widest(name for name, _ in rows), widest(value for _, value in rows)
    image, painter, _ = titled_sheet(title, names + 14 + values, 4 + ROW * len(rows))
    for i, (name, value) in enumerate(rows):
        y = PAD + ROW + 4 + i * ROW
        ink(painter, FAINT)
        painter.drawText(QtCore.QRectF(PAD, y, names + 4, ROW), QtCore.Qt.AlignVCenter, name)
        ink(painter)
        painter.drawText(QtCore.QRectF(PAD + names + 14, y, values + 4, ROW), QtCore.Qt.AlignVCenter, value)
    painter.end()
    return image
