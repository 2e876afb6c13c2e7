package badlog.page.export

import badlog.page.dom.MenuEntry
import badlog.page.dom.saveFile
import badlog.page.view.Scene
import badlog.page.view.textNear
import badlog.page.view.word
import badlog.plot.color.Shade
import badlog.plot.text.countText
import badlog.plot.text.differenceText

/**
 * Draws a figure that explains itself: above the [parts], which draw themselves one below the other, which log it is, the visible range and the
 * cursor; below them what was found in that range.
 */
internal fun Sheet.figure(scene: Scene, parts: List<(Sheet) -> Unit>) {
    line(HEADING)
    text(scene.view.title ?: scene.fileName, TITLE, scene.palette[Shade.TEXT], isBold = true)
    line(LINE)
    text(scene.placeText, LETTERS)
    for (part in parts) part(this)
    val now = scene.range.now
    val found = scene.findings.worstFirst.mapNotNull { finding ->
        finding.places.firstOrNull { it.from <= now.to && it.to >= now.from }?.let { finding to it.from }
    }
    line(GAP)
    for ((finding, x) in found.take(MOST)) {
        line(LINE)
        text("${finding.word} · ${scene.xText(x)}", LETTERS, scene.palette.severity(finding.severity), isBold = true)
        text("${finding.rule}: ${finding.textNear(x)}", LETTERS)
    }
    if (found.size <= MOST) return
    line(LINE)
    text("${countText(found.size - MOST, "more finding")} in this range", LETTERS)
}

/** The file, the visible range, and where the cursors are, with what the clocks say there. */
internal val Scene.placeText: String
    get() {
        val second = cursor.now.second
        return listOfNotNull(
            fileName.takeIf { view.title != null },
            "${xNumber(range.now.from)} – ${xText(range.now.to)}",
            if (cursor.isPlaced) "cursor at ${xText(cursor.x)}" else null,
            if (cursor.isPlaced) clocks.textAt(cursor.x).ifEmpty { null } else null,
            second?.let { "B at ${xText(it)}, ${differenceText(cursor.x, it, xAxis)}" },
        ).joinToString(" · ")
    }

/** What saves the [parts] as a picture whose file is called by [name]. */
internal fun imageEntries(scene: Scene, name: String, parts: () -> List<(Sheet) -> Unit>): List<MenuEntry> = listOf(
    MenuEntry("$name as an image (PNG)") {
        Sheet.png(WIDTH, scene.palette, { figure(scene, parts()) }) { saveFile(it, fileNameOf(scene, name, ".png")) }
    },
    MenuEntry("$name as a drawing (SVG)") {
        saveFile(Sheet.svgFile(WIDTH, scene.palette) { figure(scene, parts()) }, fileNameOf(scene, name, ".svg"))
    },
)

/** The name of a file with [part] of a log. */
internal fun fileNameOf(scene: Scene, part: String, ending: String): String {
    val stem = scene.fileName.removeSuffix(".gz").substringBeforeLast('.')
    // Slashes make folders, and some systems allow none of the others in a name.
    return "$stem $part".map { if (it < ' ' || it in "\\/:*?\"<>|") '_' else it }.joinToString("").take(MAX_NAME_LENGTH).trim() + ending
}

private const val WIDTH = 1000
private const val MOST = 8
private const val HEADING = 26
private const val TITLE = 15
private const val LINE = 18
private const val LETTERS = 12
private const val GAP = 4
private const val MAX_NAME_LENGTH = 120
