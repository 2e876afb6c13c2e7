package badlog.window.folder

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.hoverable
import androidx.compose.foundation.interaction.MutableInteractionSource
import androidx.compose.foundation.interaction.collectIsHoveredAsState
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.selection.toggleable
import androidx.compose.foundation.shape.CircleShape
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Icon
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.SpanStyle
import androidx.compose.ui.text.buildAnnotatedString
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.text.withStyle
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.catalog.folder.LogEntry
import badlog.core.recording.Severity
import badlog.viewer.shown.folder.batteryText
import badlog.viewer.shown.folder.durationText
import badlog.viewer.shown.folder.foundLines
import badlog.viewer.shown.folder.foundText
import badlog.viewer.shown.folder.isNearBrownout
import badlog.viewer.shown.folder.problemSentence
import badlog.viewer.shown.folder.problemSeverity
import badlog.viewer.shown.folder.problemText
import badlog.viewer.text.dateText
import badlog.viewer.text.word
import badlog.window.findings.findingColor
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.Palette
import badlog.window.theme.Tip

/** A log in the list: its match, date, length and result, and a preview. */
@Composable
internal fun LogRow(
    entry: LogEntry,
    previews: Previews,
    isOpen: Boolean,
    isSelected: Boolean,
    isChecked: Boolean,
    isOneOfMatch: Boolean,
    onOpen: () -> Unit,
    onCheck: () -> Unit,
) {
    val palette = LocalPalette.current
    val interactions = remember { MutableInteractionSource() }
    val isHovered by interactions.collectIsHoveredAsState()
    Row(
        Modifier
            .fillMaxWidth()
            .background(rowColor(palette, isOpen, isSelected, isHovered))
            .hoverable(interactions)
            .clickable(onClickLabel = "Open", onClick = onOpen)
            .semantics {
                contentDescription = "Log ${entry.fileName}"
                selected = isOpen
            },
    ) {
        Box(Modifier.width(28.dp).padding(start = 2.dp, top = 3.dp)) {
            if (entry.isReadable) CheckBox("Compare ${entry.fileName}", isChecked, onCheck)
        }
        Column(Modifier.weight(1f).padding(top = 6.dp, bottom = 6.dp, end = 12.dp)) {
            Row(horizontalArrangement = Arrangement.spacedBy(6.dp), verticalAlignment = Alignment.CenterVertically) {
                RowTitle(entry, isOneOfMatch, Modifier.weight(1f))
                AllianceMark(entry)
                ProblemBadge(entry)
            }
            Tip("${entry.file}\n${dateText(entry.summary.date.second)} ${entry.summary.date.source.saying}") {
                Text(
                    rowFacts(entry, palette),
                    color = palette.muted,
                    fontSize = 12.sp,
                    lineHeight = 16.sp,
                    maxLines = 1,
                    overflow = TextOverflow.Ellipsis,
                )
            }
            FoundLine(entry)
            RowPreview(entry, previews, palette)
        }
    }
}

@Composable
private fun RowPreview(entry: LogEntry, previews: Previews, palette: Palette) {
    val range = previews.range ?: return
    val topic = remember(entry, previews) { previews.of(entry) } ?: return
    val color = if (entry.isGray) palette.muted.copy(alpha = 0.5f) else palette.accent
    PreviewCurve(topic, range, color, Modifier.fillMaxWidth().padding(top = 3.dp).height(16.dp))
}

/** The worst result of the rules; empty if it is only a note. */
@Composable
private fun FoundLine(entry: LogEntry) {
    val verdict = entry.found?.verdict ?: return
    val palette = LocalPalette.current
    val color = palette.findingColor(verdict.severity)
    Tip(foundLines(entry)) {
        Row(
            Modifier.semantics { contentDescription = "${verdict.severity.word}: ${foundText(entry)}" },
            Arrangement.spacedBy(4.dp),
            Alignment.CenterVertically,
        ) {
            Icon(Icons.Diamond, contentDescription = null, Modifier.size(11.dp), color)
            Text(
                foundText(entry).orEmpty(),
                color = color,
                fontSize = 12.sp,
                lineHeight = 16.sp,
                maxLines = 1,
                overflow = TextOverflow.Ellipsis,
            )
        }
    }
}

/** The title of [entry] and, where there is room, its file name or event. */
@Composable
private fun RowTitle(entry: LogEntry, isOneOfMatch: Boolean, modifier: Modifier) {
    val palette = LocalPalette.current
    val color = if (entry.isGray) palette.muted else palette.text
    val weight = if (entry.isGray) FontWeight.Normal else FontWeight.SemiBold
    val more = if (isOneOfMatch) entry.fileName else entry.summary.match.event.takeIf { entry.summary.match.match != null }
    Row(modifier, Arrangement.spacedBy(8.dp)) {
        NameText(entry.title, color = color, fontWeight = weight, cut = NameCut.MIDDLE)
        if (more != null) NameText(more, Modifier.weight(1f), palette.muted, cut = if (isOneOfMatch) NameCut.MIDDLE else NameCut.WORDS)
    }
}

private fun rowFacts(entry: LogEntry, palette: Palette): AnnotatedString = buildAnnotatedString {
    append(dateText(entry.summary.date.second))
    val saying = entry.summary.content.saying
    if (saying.isNotEmpty()) {
        append(" · $saying")
        return@buildAnnotatedString
    }
    durationText(entry)?.let { append(" · $it") }
    batteryText(entry)?.let {
        append(" · ")
        withStyle(SpanStyle(batteryColor(entry, palette, palette.muted))) { append(it) }
    }
}

/** Returns red if the robot came near a brownout, otherwise [usual]. */
internal fun batteryColor(entry: LogEntry, palette: Palette, usual: Color): Color = if (entry.isNearBrownout) palette.error else usual

/** Returns the background of a row. */
internal fun rowColor(palette: Palette, isOpen: Boolean, isSelected: Boolean, isHovered: Boolean): Color = when {
    isOpen || isSelected -> palette.accentSoft
    isHovered -> palette.raised
    else -> Color.Transparent
}

/** A small check box. */
@Composable
internal fun CheckBox(description: String, isChecked: Boolean, onCheck: () -> Unit) {
    val palette = LocalPalette.current
    val shape = RoundedCornerShape(3.dp)
    Box(
        Modifier
            .toggleable(isChecked, role = Role.Checkbox) { onCheck() }
            .semantics { contentDescription = description }
            .padding(6.dp)
            .size(14.dp)
            .background(if (isChecked) palette.accent else Color.Transparent, shape)
            .border(1.dp, if (isChecked) palette.accent else palette.muted.copy(alpha = 0.5f), shape),
        contentAlignment = Alignment.Center,
    ) {
        if (isChecked) Icon(Icons.Check, contentDescription = null, Modifier.size(12.dp), palette.surface)
    }
}

/** A dot in the alliance's color; empty if the alliance is unknown. */
@Composable
internal fun AllianceMark(entry: LogEntry) {
    val palette = LocalPalette.current
    val color = when (entry.summary.match.alliance) {
        "Red" -> if (palette.isDark) Color(0xFFFF6B60) else Color(0xFFD0342C)
        "Blue" -> if (palette.isDark) Color(0xFF5AA9FF) else Color(0xFF1F66D0)
        else -> return
    }
    Tip("${entry.summary.match.alliance} alliance") { Box(Modifier.size(8.dp).background(color, CircleShape)) }
}

/** The number of problems that matter; empty if none does. */
@Composable
internal fun ProblemBadge(entry: LogEntry) {
    val text = problemText(entry) ?: return
    val palette = LocalPalette.current
    val isError = entry.problemSeverity == Severity.ERROR
    val color = if (isError) palette.error else palette.warning
    Tip(problemSentence(entry)) {
        Row(
            Modifier
                .background(if (isError) palette.errorSoft else palette.warningSoft, RoundedCornerShape(8.dp))
                .padding(horizontal = 5.dp),
            horizontalArrangement = Arrangement.spacedBy(3.dp),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            Icon(Icons.Warning, contentDescription = null, Modifier.size(11.dp), color)
            if (entry.isReadable) Text(text, color = color, fontSize = 11.sp, lineHeight = 16.sp)
        }
    }
}
