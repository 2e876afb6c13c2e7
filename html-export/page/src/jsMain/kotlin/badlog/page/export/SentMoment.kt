package badlog.page.export

import badlog.page.dom.MenuEntry
import badlog.page.dom.json
import badlog.page.dom.saveFile
import badlog.page.pen.CanvasPen
import badlog.page.view.Scene
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.figure.FigureNotes
import badlog.viewer.draw.figure.Sheet
import badlog.viewer.draw.figure.figure
import badlog.viewer.draw.pen.SvgPen
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.files.Blob
import org.w3c.files.BlobPropertyBag
import org.w3c.files.File
import org.w3c.files.FilePropertyBag
import kotlin.js.Promise

/**
 * Sends [text] with a picture of [parts] in the first way that works. It tries the system's own dialog, as on phones, then the clipboard,
 * and finally saves the picture as a file.
 */
internal fun sendMoment(scene: Scene, text: String, parts: List<(Sheet) -> Unit>) = pictureOf(scene, parts) { picture ->
    val name = fileNameOf(scene, "moment", ".png")
    val file = File(arrayOf<dynamic>(picture), name, FilePropertyBag(type = "image/png"))
    val message = json("files" to arrayOf(file), "text" to text)
    shared(message).then({}, { problem ->
        // A reader who closes the system's dialog wants nothing else.
        if (problem.asDynamic().name == "AbortError") return@then
        copied(picture, text).then({ scene.notice.say("Picture and text copied: paste them into a message.") }, {
            saveFile(picture, name)
            scene.notice.say("The picture was saved, because this browser does not let pages send it.")
        })
    })
}

private fun shared(message: dynamic): Promise<Unit> = try {
    val navigator = window.navigator.asDynamic()
    if (navigator.canShare(message) == true) navigator.share(message).unsafeCast<Promise<Unit>>() else Promise.reject(Error())
} catch (problem: Throwable) {
    // Pages on a disk, and most desktops, have no such dialog.
    Promise.reject(problem)
}

private fun copied(picture: Blob, text: String): Promise<Unit> = try {
    val content = json("image/png" to picture, "text/plain" to Blob(arrayOf(text), BlobPropertyBag("text/plain")))
    val newItem = js("(content) => new ClipboardItem(content)")
    window.navigator.asDynamic().clipboard.write(arrayOf(newItem(content))).unsafeCast<Promise<Unit>>()
} catch (problem: Throwable) {
    Promise.reject(problem)
}

/** The texts of a figure of the visible range. */
internal val Scene.figureNotes: FigureNotes
    get() = FigureNotes.of(if (view.title == null) "" else fileName, xAxis, range.now, cursor.now, clocks, findings)

/** Returns menu entries that save the [parts] as a picture in a file named after [name]. */
internal fun imageEntries(scene: Scene, name: String, parts: () -> List<(Sheet) -> Unit>): List<MenuEntry> {
    fun Sheet.draw() = figure(scene.view.title ?: scene.fileName, scene.figureNotes, parts())
    return listOf(
        MenuEntry("$name as an image (PNG)") { pngOf(WIDTH, { draw() }) { saveFile(it, fileNameOf(scene, name, ".png")) } },
        MenuEntry("$name as a drawing (SVG)") {
            val file = Blob(arrayOf(svgOf(WIDTH) { draw() }), BlobPropertyBag("image/svg+xml"))
            saveFile(file, fileNameOf(scene, name, ".svg"))
        },
    )
}

/** Draws the [parts] as a picture of the visible range, and passes it to [onReady] as PNG. */
internal fun pictureOf(scene: Scene, parts: List<(Sheet) -> Unit>, onReady: (Blob) -> Unit) =
    pngOf(WIDTH, { figure(scene.view.title ?: scene.fileName, scene.figureNotes, parts) }, onReady)

/** Returns the picture that [draw] draws, as SVG. */
internal fun svgOf(width: Int, draw: Sheet.() -> Unit): String {
    val ruler = CanvasPen(newCanvas())
    // A page may show several drawings, and the names of their parts must differ.
    val pen = SvgPen(ruler::widthOf, "drawing${++drawings}-")
    val sheet = Sheet(width, pen).apply(draw)
    return pen.document(width.toDouble(), sheet.height, PenColors.LIGHT[Shade.SURFACE])
}

/** Draws [draw] as PNG, in the resolution of the screen, and passes it to [onReady]. */
private fun pngOf(width: Int, draw: Sheet.() -> Unit, onReady: (Blob) -> Unit) {
    val ratio = window.devicePixelRatio
    val context = newCanvas()
    val canvas = context.canvas
    // Its height is known only after drawing.
    val height = Sheet(width, CanvasPen(context)).apply(draw).height
    canvas.width = (width * ratio).toInt()
    canvas.height = (height * ratio).toInt()
    val pen = CanvasPen(context)
    pen.rectangle(0.0, 0.0, canvas.width.toDouble(), canvas.height.toDouble(), PenColors.LIGHT[Shade.SURFACE])
    Sheet(width, pen).draw()
    canvas.toBlob({ blob: Blob? -> if (blob != null) onReady(blob) })
}

private fun newCanvas(): CanvasRenderingContext2D =
    document.createElement("canvas").unsafeCast<HTMLCanvasElement>().getContext("2d").unsafeCast<CanvasRenderingContext2D>()

/** Returns the name of a file for a [part] of the log. */
internal fun fileNameOf(scene: Scene, part: String, ending: String): String {
    val stem = scene.fileName.removeSuffix(".gz").substringBeforeLast('.')
    // Slashes make folders, and some systems forbid the other characters in names.
    return "$stem $part".map { if (it < ' ' || it in "\\/:*?\"<>|") '_' else it }.joinToString("").take(MAX_NAME_LENGTH).trim() + ending
}

private var drawings = 0
private const val WIDTH = 1000
private const val MAX_NAME_LENGTH = 120
