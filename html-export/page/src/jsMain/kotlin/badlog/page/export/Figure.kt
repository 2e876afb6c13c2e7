package badlog.page.export

import badlog.page.dom.MenuEntry
import badlog.page.dom.saveFile
import badlog.page.view.Scene
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.figure.FigureNotes
import badlog.viewer.text.countText

/**
 * Draws a self-explanatory figure: at the top the log's name, the visible range and the cursor; then the [parts], which draw themselves one
 * below the other; at the bottom the findings in that range.
 */
internal fun Sheet.figure(scene: Scene, parts: List<(Sheet) -> Unit>) {
    val notes = scene.figureNotes
    line(HEADING)
    text(scene.view.title ?: scene.fileName, TITLE, scene.palette[Shade.TEXT], isBold = true)
    line(LINE)
    text(notes.place, LETTERS)
    for (part in parts) part(this)
    line(GAP)
    for (finding in notes.findings) {
        line(LINE)
        text(finding.head, LETTERS, scene.palette.severity(finding.severity), isBold = true)
        text(finding.text, LETTERS)
    }
    if (notes.moreFindings == 0) return
    line(LINE)
    text("${countText(notes.moreFindings, "more finding")} in this range", LETTERS)
}

/** The texts of a figure of the visible range. */
internal val Scene.figureNotes: FigureNotes
    get() = FigureNotes.of(if (view.title == null) "" else fileName, xAxis, range.now, cursor.now, clocks, findings)

/** Returns menu entries that save the [parts] as a picture whose file is named after [name]. */
internal fun imageEntries(scene: Scene, name: String, parts: () -> List<(Sheet) -> Unit>): List<MenuEntry> = listOf(
    MenuEntry("$name as an image (PNG)") {
        Sheet.png(WIDTH, scene.palette, { figure(scene, parts()) }) { saveFile(it, fileNameOf(scene, name, ".png")) }
    },
    MenuEntry("$name as a drawing (SVG)") {
        saveFile(Sheet.svgFile(WIDTH, scene.palette) { figure(scene, parts()) }, fileNameOf(scene, name, ".svg"))
    },
)

/** Returns the name of a file with [part] of a log. */
internal fun fileNameOf(scene: Scene, part: String, ending: String): String {
    val stem = scene.fileName.removeSuffix(".gz").substringBeforeLast('.')
    // Slashes make folders, and some systems do not allow the others in a name.
    return "$stem $part".map { if (it < ' ' || it in "\\/:*?\"<>|") '_' else it }.joinToString("").take(MAX_NAME_LENGTH).trim() + ending
}

private const val WIDTH = 1000
private const val HEADING = 26
private const val TITLE = 15
private const val LINE = 18
private const val LETTERS = 12
private const val GAP = 4
private const val MAX_NAME_LENGTH = 120
