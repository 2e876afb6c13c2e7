package badlog.window.graph.mark

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.DrawScope
import badlog.core.analysis.Span
import badlog.protocol.Note
import badlog.window.graph.plot.pixelOf
import badlog.window.theme.Palette

/** Draws a line and a flag where a person wrote one of [notes], as far as that is [visible]. */
internal fun DrawScope.drawNoteMarks(notes: List<Note>, visible: Span, palette: Palette) {
    for (note in notes) {
        if (note.x !in visible) continue
        val x = pixelOf(note.x, visible, size.width)
        drawLine(palette.accent, Offset(x, 0f), Offset(x, size.height), strokeWidth = density)
        drawRect(palette.accent, Offset(x, 0f), Size(FLAG_WIDTH * density, FLAG_HEIGHT * density))
    }
}

private const val FLAG_WIDTH = 9f
private const val FLAG_HEIGHT = 6f
