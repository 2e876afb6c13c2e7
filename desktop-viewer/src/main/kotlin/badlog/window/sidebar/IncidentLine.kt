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
import badlog.window.findings.findingColor
import badlog.window.findings.findingSoft
import badlog.window.theme.LocalPalette

/**
 * An incident: what came first and what followed, each linked to its place, and what to look at next. Its name goes to what came first.
 *
 * @param isOpen whether a person went to one of its findings; then it is framed.
 */
@Composable
internal fun IncidentLine(incident: Incident, times: EventTimes, isOpen: Boolean, onClick: (Finding) -> Unit) {
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
            incident.name,
            Modifier
                .fillMaxWidth()
                .clickable(role = Role.Button) { onClick(incident.sentences.first().finding) }
                .semantics {
                    contentDescription = "Incident: ${incident.name}"
                    selected = isOpen
                },
            color = color,
            fontWeight = FontWeight.Medium,
        )
        for (sentence in incident.sentences) {
            val time = sentence.finding.time
            Row(
                Modifier.fillMaxWidth().clickable(role = Role.Button) { onClick(sentence.finding) }.padding(vertical = 2.dp),
                Arrangement.spacedBy(6.dp),
            ) {
                Text(if (time.isFinite()) times.logged(time) else "whole log", color = palette.muted, fontSize = 11.sp)
                Text(sentence.text, Modifier.weight(1f))
            }
        }
        if (incident.next.isNotEmpty()) Text("Next: ${incident.next}", color = palette.muted, fontSize = 12.sp)
    }
}
