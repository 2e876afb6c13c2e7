package badlog.window.sidebar

import androidx.compose.foundation.VerticalScrollbar
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.lazy.LazyColumn
import androidx.compose.foundation.lazy.items
import androidx.compose.foundation.lazy.rememberLazyListState
import androidx.compose.foundation.rememberScrollbarAdapter
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.text.selection.SelectionContainer
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.core.recording.Problem
import badlog.core.recording.Severity
import badlog.viewer.text.placeTextOf
import badlog.viewer.text.problemSummary
import badlog.viewer.text.word
import badlog.window.log.OpenRecording
import badlog.window.theme.LocalPalette
import badlog.window.theme.Palette

/** The problems in the file, the worst first. */
@Composable
internal fun ProblemsPanel(open: OpenRecording, modifier: Modifier) {
    val palette = LocalPalette.current
    val problems = remember(open) { worstFirst(open.view.problems) }
    val worst = problems.firstOrNull()?.severity
    val state = rememberLazyListState()
    Column(modifier) {
        Text(
            problemSummary(problems),
            Modifier.fillMaxWidth().background(palette.softOf(worst)).padding(horizontal = 12.dp, vertical = 8.dp),
            color = if (worst == null) palette.text else palette.colorOf(worst),
            fontWeight = FontWeight.Medium,
        )
        Box(Modifier.fillMaxSize()) {
            SelectionContainer {
                LazyColumn(Modifier.fillMaxSize(), state) { items(problems) { ProblemLine(it) } }
            }
            VerticalScrollbar(rememberScrollbarAdapter(state), Modifier.align(Alignment.CenterEnd).fillMaxHeight())
        }
    }
}

@Composable
private fun ProblemLine(problem: Problem) {
    val palette = LocalPalette.current
    Row(
        Modifier.fillMaxWidth().padding(start = 12.dp, end = 14.dp, top = 5.dp, bottom = 5.dp),
        horizontalArrangement = Arrangement.spacedBy(8.dp),
    ) {
        Text(
            problem.word,
            Modifier
                .width(58.dp)
                .background(palette.softOf(problem.severity), RoundedCornerShape(4.dp))
                .padding(horizontal = 4.dp),
            color = palette.colorOf(problem.severity),
            fontSize = 12.sp,
            textAlign = TextAlign.Center,
        )
        Column(Modifier.weight(1f)) {
            Text(problem.message, maxLines = 8, overflow = TextOverflow.Ellipsis)
            val place = placeTextOf(problem)
            if (place.isNotEmpty()) {
                Text(place, color = palette.muted, fontSize = 12.sp, maxLines = 2, overflow = TextOverflow.Ellipsis)
            }
        }
    }
}

private fun Palette.colorOf(severity: Severity): Color = when (severity) {
    Severity.ERROR -> error
    Severity.WARNING -> warning
    Severity.NOTE -> muted
}

private fun Palette.softOf(severity: Severity?): Color = when (severity) {
    Severity.ERROR -> errorSoft
    Severity.WARNING -> warningSoft
    Severity.NOTE, null -> raised
}

/** Returns losses, then warnings, then hints; problems of one severity stay in order. */
internal fun worstFirst(problems: List<Problem>): List<Problem> = problems.sortedByDescending { it.severity }
