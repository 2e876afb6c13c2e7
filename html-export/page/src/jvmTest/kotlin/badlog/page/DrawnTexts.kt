package badlog.page

/** A text that a page drew on a canvas, with its position in CSS pixels of that canvas. */
internal data class DrawnText(val text: String, val left: Double, val right: Double, val y: Double)

/** A script that records the texts on each canvas of a page; run it before the page's own script. */
internal const val NOTING_TEXTS: String = """
    const draw = CanvasRenderingContext2D.prototype.fillText;
    CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
        const width = this.measureText(text).width, at = this.getTransform().transformPoint({x, y});
        const share = {left: 0, start: 0, center: 0.5, right: 1, end: 1}[this.textAlign], ratio = devicePixelRatio;
        const left = at.x - width * share;
        (this.canvas.texts ??= []).push([String(text), left / ratio, (left + width) / ratio, at.y / ratio]);
        return draw.apply(this, arguments);
    };
    const copy = CanvasRenderingContext2D.prototype.drawImage;
    CanvasRenderingContext2D.prototype.drawImage = function (picture, ...places) {
        const ratio = devicePixelRatio, [x, y] = places.length > 2 ? places.slice(4) : places, move = ([text, left, right, down]) => [text, left + x / ratio, right + x / ratio, down + y / ratio];
        (this.canvas.texts ??= []).push(...(picture.texts ?? []).map(move));
        return copy.apply(this, arguments);
    };
    const clear = CanvasRenderingContext2D.prototype.clearRect;
    CanvasRenderingContext2D.prototype.clearRect = function () {
        this.canvas.texts = [];
        return clear.apply(this, arguments);
    };
"""

/** Returns the texts drawn on the canvas of the graph [name], on a page with [NOTING_TEXTS]. */
internal fun OpenPage.drawnTexts(name: String): List<DrawnText> {
    val texts = script("return arguments[0].querySelector('canvas').texts ?? []", graph(name).card) as List<*>
    return texts.map { text ->
        val (left, right, y) = (text as List<*>).drop(1).map { (it as Number).toDouble() }
        DrawnText(text[0] as String, left, right, y)
    }
}

/** Returns the left edge of the frame of the graph [name] in its canvas. */
internal fun OpenPage.frameLeft(name: String): Double = number(
    "const [card] = arguments; return card.querySelector('.plot-frame').getBoundingClientRect().x - " +
        "card.querySelector('canvas').getBoundingClientRect().x",
    graph(name).card,
)
