package badlog.window.folder

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.gestures.detectTapGestures
import androidx.compose.foundation.hoverable
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.interaction.collectIsHoveredAsState
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.focusProperties
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.onClick
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextDecoration
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.catalog.folder.LogEntry
import badlog.core.recording.Severity
import badlog.viewer.shown.folder.LogColumn
import badlog.viewer.shown.folder.foundLines
import badlog.viewer.shown.folder.problemSeverity
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.Palette
import badlog.window.theme.Tip
import java.nio.file.Path

/** The width of the check box, in dp. */
internal const val CHECK_WIDTH = 34

/** The width of the preview, in dp. */
internal const val PREVIEW_WIDTH = 152

/** The columns' titles; a click sorts. The last column is wider by [spare]. */
@Composable
internal fun TableHead(library: Library, previewTopic: String?, spare: Dp) {
    val palette = LocalPalette.current
    val listing = library.state.listing
    Row(Modifier.fillMaxWidth().background(palette.raised).padding(start = CHECK_WIDTH.dp)) {
        for (column in LogColumn.entries) {
            if (column == LogColumn.FILE) PreviewTitle(previewTopic)
            Row(
                Modifier
                    .width(widthOf(column, spare))
                    .clickable(role = Role.Button) { library.change { sorted(column) } }
                    .focusProperties { canFocus = false }
                    .semantics { contentDescription = "Sort by ${column.title}" }
                    .padding(horizontal = 8.dp, vertical = 6.dp),
                horizontalArrangement = if (column.isNumber) Arrangement.End else Arrangement.Start,
                verticalAlignment = Alignment.CenterVertically,
            ) {
                val isSorted = column == listing.column
                val color = if (isSorted) palette.accent else palette.muted
                Text(column.title, color = color, fontSize = 12.sp, fontWeight = FontWeight.SemiBold, maxLines = 1)
                if (isSorted) Icon(if (listing.isDescending) Icons.Down else Icons.Up, null, Modifier.size(12.dp), color)
            }
        }
    }
}

@Composable
private fun PreviewTitle(topic: String?) {
    NameText(
        topic ?: "Battery voltage",
        Modifier.width(PREVIEW_WIDTH.dp).padding(horizontal = 8.dp, vertical = 6.dp),
        color = LocalPalette.current.muted,
        fontSize = 12.sp,
        fontWeight = FontWeight.SemiBold,
    )
}

/** A log in the table. A click on its findings calls [onFindings]. */
@Composable
internal fun TableRow(
    entry: LogEntry,
    previews: Previews,
    spare: Dp,
    folder: Path?,
    isOpen: Boolean,
    isSelected: Boolean,
    isChecked: Boolean,
    onCheck: () -> Unit,
    onSelect: () -> Unit,
    onOpen: () -> Unit,
    onFindings: () -> Unit,
) {
    val palette = LocalPalette.current
    val select by rememberUpdatedState(onSelect)
    val open by rememberUpdatedState(onOpen)
    val interactions = remember { MutableInteractionSource() }
    val isHovered by interactions.collectIsHoveredAsState()
    Row(
        Modifier
            .fillMaxWidth()
            .height(28.dp)
            .background(rowColor(palette, isOpen = false, isSelected = isSelected, isHovered = isHovered))
            .hoverable(interactions)
            .pointerInput(Unit) { detectTapGestures(onPress = { select() }, onDoubleTap = { open() }) }
            .semantics {
                contentDescription = "Log ${entry.fileName}"
                selected = isSelected
                onClick("Open") {
                    open()
                    true
                }
            },
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Box(Modifier.width(CHECK_WIDTH.dp).padding(start = 4.dp)) {
            if (entry.isReadable) CheckBox("Compare ${entry.fileName}", isChecked, onCheck)
        }
        for (column in LogColumn.entries) {
            if (column == LogColumn.FILE) RowPreview(entry, previews, palette)
            val color = cellColor(entry, column, palette)
            val isLink = column == LogColumn.FINDINGS && entry.found?.worst != null
            val cell = @Composable { width: Modifier ->
                val text = cellText(entry, column, folder)
                val place = width.padding(horizontal = 8.dp)
                val weight = if (isOpen) FontWeight.SemiBold else FontWeight.Normal
                if (column == LogColumn.FILE || column == LogColumn.EVENT) {
                    val isEvent = column == LogColumn.EVENT && text == entry.summary.match.event
                    NameText(text, place, color, fontWeight = weight, cut = if (isEvent) NameCut.WORDS else NameCut.MIDDLE)
                } else {
                    Text(
                        text,
                        place,
                        color = color,
                        fontWeight = weight,
                        textAlign = if (column.isNumber) TextAlign.End else TextAlign.Start,
                        maxLines = 1,
                        textDecoration = TextDecoration.Underline.takeIf { isLink && isHovered },
                        overflow = TextOverflow.Ellipsis,
                    )
                }
            }
            val width = Modifier.width(widthOf(column, spare))
            if (isLink) {
                // The link is there without a tooltip, too, because a click may begin before the tooltip appears.
                Box(width.then(linkTo(entry, onFindings)), propagateMinConstraints = true) {
                    // A tooltip costs as much as the rest of the row, so only the one under the pointer has it.
                    if (isHovered) Tip(foundLines(entry)) { cell(Modifier.fillMaxWidth()) } else cell(Modifier)
                }
            } else {
                cell(width)
            }
        }
    }
}

/** Makes a click go to the findings. It takes no keyboard focus, because keys move from log to log. */
private fun linkTo(entry: LogEntry, onFindings: () -> Unit) = Modifier
    .focusProperties { canFocus = false }
    .clickable(role = Role.Button, onClick = onFindings)
    .semantics { contentDescription = "Findings of ${entry.fileName}" }

@Composable
private fun RowPreview(entry: LogEntry, previews: Previews, palette: Palette) {
    Box(
        Modifier.width(PREVIEW_WIDTH.dp).height(28.dp).padding(horizontal = 8.dp, vertical = 4.dp),
        contentAlignment = Alignment.CenterStart,
    ) {
        val range = previews.range
        val topic = remember(entry, previews) { previews.of(entry) }
        if (entry.isGray) {
            Text(entry.summary.content.saying, color = palette.muted, fontSize = 12.sp, maxLines = 1, overflow = TextOverflow.Ellipsis)
        } else if (range != null && topic != null) {
            PreviewCurve(topic, range, palette.accent, Modifier.fillMaxWidth().height(20.dp))
        }
    }
}

private fun cellText(entry: LogEntry, column: LogColumn, folder: Path?): String = when {
    // A log without a match has its name in the first column. In a small window, the file's column is out of sight.
    column == LogColumn.EVENT && entry.summary.match.event == null && entry.summary.match.number == null -> entry.fileName

    column != LogColumn.FILE -> column.text(entry).orEmpty()

    folder != null && entry.file.startsWith(folder) -> folder.relativize(entry.file).toString()

    else -> entry.file.toString()
}

private fun cellColor(entry: LogEntry, column: LogColumn, palette: Palette): Color {
    val usual = if (entry.isGray) palette.muted else palette.text
    return when {
        column == LogColumn.BATTERY -> batteryColor(entry, palette, usual)
        column == LogColumn.FINDINGS -> foundColor(entry, palette, usual)
        column != LogColumn.PROBLEMS -> usual
        entry.problemSeverity == Severity.ERROR -> palette.error
        else -> palette.warning
    }
}

private fun foundColor(entry: LogEntry, palette: Palette, usual: Color): Color = when (entry.found?.worst) {
    Severity.ERROR -> palette.error
    Severity.WARNING -> palette.warning
    Severity.NOTE -> usual
    null -> palette.muted
}

private fun widthOf(column: LogColumn, spare: Dp): Dp = column.width.dp + if (column == LogColumn.FILE) spare else 0.dp
