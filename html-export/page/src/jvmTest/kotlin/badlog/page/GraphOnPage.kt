package badlog.page

import org.openqa.selenium.Keys
import org.openqa.selenium.WebElement
import java.util.Base64

/** Returns the graph with the full name [name]. */
internal fun OpenPage.graph(name: String): GraphOnPage = GraphOnPage(this, name)

/** One graph of an open page, as a reader sees and operates it. */
internal class GraphOnPage(private val page: OpenPage, private val name: String) {
    /** Its card. */
    val card: WebElement
        get() {
            val find = "return [...document.querySelectorAll('.graph')].find(e => e.dataset.name === arguments[0])"
            val card = page.script(find, name) as WebElement?
            return checkNotNull(card) { "There is no “$name”, but ${page.graphNames}." }
        }

    /** Whether it is drawn now. */
    val isDrawn: Boolean get() = page.script("return !!arguments[0].querySelector('canvas')", card) as Boolean

    /** Whether some of its frame is on the screen. */
    val isOnScreen: Boolean
        get() = page.script(
            "const b = arguments[0].querySelector('.plot').getBoundingClientRect();" +
                "return b.height > 0 && b.bottom > 0 && b.top < innerHeight",
            card,
        ) as Boolean

    /** Scrolls it to the middle of the screen. */
    fun scrollTo(): GraphOnPage {
        page.script("arguments[0].scrollIntoView({block: 'center', behavior: 'instant'})", card)
        page.await("the graph $name to be drawn") { isDrawn }
        page.settle()
        return this
    }

    /** The position of its frame on the screen. */
    val frame: Box
        get() {
            val numbers = page.script(
                "const b = arguments[0].querySelector('.plot-frame').getBoundingClientRect();" +
                    "return [b.x, b.y, b.width, b.height]",
                card,
            ) as List<*>
            val (x, y, width, height) = numbers.map { (it as Number).toDouble() }
            return Box(x, y, width, height)
        }

    /** A rectangle in CSS pixels. */
    data class Box(val x: Double, val y: Double, val width: Double, val height: Double) {
        /** Returns the pixel at the share [across] of the width and [down] of the height. */
        fun at(across: Double, down: Double = 0.5): Pair<Int, Int> = (x + width * across).toInt() to (y + height * down).toInt()
    }

    /** Moves the mouse to the share [across] of the frame's width. */
    fun hover(across: Double) {
        val (x, y) = frame.at(across)
        // From beside it, so that the browser notices a move even if the mouse is already there.
        page.act { mouseTo(x, y + 3).mouseTo(x, y) }
    }

    /** Drags the mouse from one share of the frame's width to another. */
    fun drag(from: Double, to: Double, withShift: Boolean = false) {
        val (startX, y) = frame.at(from)
        val (endX, _) = frame.at(to)
        page.act {
            mouseTo(startX, y)
            if (withShift) keyDown(Keys.SHIFT)
            mouseDown().mouseTo((startX + endX) / 2, y).mouseTo(endX, y).mouseUp()
            if (withShift) keyUp(Keys.SHIFT)
            this
        }
    }

    /** Clicks the share [across] of the frame's width. */
    fun click(across: Double, withShift: Boolean = false) {
        val (x, y) = frame.at(across)
        page.act {
            mouseTo(x, y)
            if (withShift) keyDown(Keys.SHIFT)
            mouseDown().mouseUp()
            if (withShift) keyUp(Keys.SHIFT)
            this
        }
    }

    /** Double-clicks in its middle. */
    fun doubleClick() {
        val (x, y) = frame.at(0.5)
        page.doubleClick(x, y)
    }

    /** Returns the legend's text for [line] at the cursor. */
    fun value(line: String): String = page.script("return arguments[0].querySelector('.value').textContent", legend(line)) as String

    /** The text of the finding at the cursor. */
    val label: String
        get() = page.script("return arguments[0].querySelector('.finding-label:not([hidden])')?.textContent ?? ''", card) as String

    /** The legend's button of [line]. */
    fun legend(line: String): WebElement = page.script(
        "return [...arguments[0].querySelectorAll('.legend-entry')].find(e => e.dataset.series === arguments[1])",
        card,
        line,
    ) as WebElement

    /** The drawing inside its frame, read from the canvas itself, not from the page's texts. */
    val picture: FramePicture
        get() {
            val drawn = page.script(
                """
                const canvas = arguments[0].querySelector('canvas');
                const over = arguments[0].querySelector('.plot-frame').getBoundingClientRect();
                const box = canvas.getBoundingClientRect(), ratio = canvas.width / box.width;
                const place = [over.x - box.x, over.y - box.y, over.width, over.height];
                return [canvas.toDataURL().split(',')[1], ...place.map(n => Math.round(n * ratio))];
                """.trimIndent(),
                card,
            ) as List<*>
            val (left, top, width, height) = drawn.drop(1).map { (it as Number).toInt() }
            val png = Base64.getDecoder().decode(drawn[0] as String)
            return FramePicture.of(png.inputStream(), left, top, width, height)
        }

    /** The whole canvas as text, to compare it with another canvas. */
    val canvas: String get() = page.script("return arguments[0].querySelector('canvas').toDataURL()", card) as String

    /** Returns for each pixel column of the frame the number of its pixels with the color of line [index]. */
    fun lineColumns(index: Int = 0): List<Int> = picture.columnsOf(page.color("--line-$index"))

    /** Returns the number of pixels of the canvas with the color of line [index]. */
    fun pixelsOfLine(index: Int): Int = lineColumns(index).sum()

    /** Returns the x at which line [index] rises or falls the most, as a share of the frame's width. */
    fun steepest(index: Int = 0): Double = lineColumns(index).let { (it.indexOf(it.max()) + 0.5) / it.size }
}
