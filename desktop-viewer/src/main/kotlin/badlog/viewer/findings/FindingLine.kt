package badlog.viewer.findings

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.report.rules.Finding
import badlog.viewer.inspector.EventTimes
import badlog.viewer.inspector.inspectorLine
import badlog.viewer.theme.LocalPalette

/** A finding: how bad, when, which rule, and what it says. */
@Composable
internal fun FindingLine(finding: Finding, times: EventTimes, isChosen: Boolean, onClick: () -> Unit) {
    val palette = LocalPalette.current
    Row(
        Modifier.inspectorLine("Finding, ${finding.severity.word}: ${finding.rule}", isChosen, gap = 5.dp, onClick),
        horizontalArrangement = Arrangement.spacedBy(8.dp),
    ) {
        Column(Modifier.width(62.dp)) {
            Text(
                finding.severity.word,
                Modifier
                    .fillMaxWidth()
                    .background(palette.findingSoft(finding.severity), RoundedCornerShape(4.dp))
                    .padding(horizontal = 4.dp),
                color = palette.findingColor(finding.severity),
                fontSize = 12.sp,
                textAlign = TextAlign.Center,
            )
            val since = times.sinceEnabled(finding.time)
            if (since != null) Time(since)
            Time(if (finding.time.isFinite()) times.logged(finding.time) else "whole log")
        }
        Column(Modifier.weight(1f)) {
            Text(finding.rule, fontWeight = FontWeight.Medium, maxLines = 1, overflow = TextOverflow.Ellipsis)
            Text(finding.text, maxLines = 6, overflow = TextOverflow.Ellipsis)
        }
    }
}

@Composable
private fun Time(text: String) {
    Text(
        text,
        Modifier.fillMaxWidth(),
        color = LocalPalette.current.muted,
        fontSize = 11.sp,
        textAlign = TextAlign.End,
        maxLines = 1,
        overflow = TextOverflow.Ellipsis,
    )
}
