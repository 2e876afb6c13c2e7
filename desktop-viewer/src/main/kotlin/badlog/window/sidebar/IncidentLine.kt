package badlog.window.sidebar

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.selected
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.rules.Finding
import badlog.rules.incident.Incident
import badlog.viewer.text.word
import badlog.window.findings.findingColor
import badlog.window.findings.findingSoft
import badlog.window.theme.LocalPalette

/**
 * An incident: how serious it is, what came first and what followed, each linked to its place, and what to look at next. Its name goes to
 * what came first.
 *
 * @param selected the finding that a person went to; the incident that it is a part of is framed.
 * @param details shows more about a finding.
 */
@Composable
internal fun IncidentLine(
    incident: Incident,
    times: EventTimes,
    selected: Finding?,
    onClick: (Finding) -> Unit,
    details: @Composable (Finding) -> Unit,
) {
    val isOpen = selected != null && selected in incident
    val palette = LocalPalette.current
    val color = palette.findingColor(incident.severity)
    val shape = RoundedCornerShape(4.dp)
    Column(
        Modifier
            .fillMaxWidth()
            .padding(start = 8.dp, end = 14.dp, top = 3.dp, bottom = 3.dp)
            .background(palette.findingSoft(incident.severity), shape)
            .border(2.dp, if (isOpen) color else Color.Transparent, shape)
            .padding(horizontal = 6.dp, vertical = 4.dp),
    ) {
        Text(
            "${incident.severity.word}: ${incident.name}",
            Modifier
                .fillMaxWidth()
                .clickable(role = Role.Button) { onClick(incident.sentences.first().finding) }
                .semantics {
                    contentDescription = "Incident: ${incident.name}"
                    this.selected = isOpen
                },
            color = color,
            fontWeight = FontWeight.Medium,
        )
        for (sentence in incident.sentences) {
            val finding = sentence.finding
            val time = finding.time
            Row(
                Modifier
                    .fillMaxWidth()
                    .clickable(role = Role.Button) { onClick(finding) }
                    .semantics {
                        contentDescription = "Finding, ${finding.severity.word}: ${finding.rule}"
                        this.selected = finding === selected
                    }
                    .padding(vertical = 2.dp),
                Arrangement.spacedBy(6.dp),
            ) {
                Text(if (time.isFinite()) times.logged(time) else "whole log", color = palette.muted, fontSize = 11.sp)
                Text(sentence.text, Modifier.weight(1f))
            }
        }
        val shown = incident.sentences.map { it.finding }.find { it === selected }
        when {
            shown != null -> details(shown)
            incident.next.isNotEmpty() -> Text("Next: ${incident.next}", color = palette.muted, fontSize = 12.sp)
        }
    }
}
