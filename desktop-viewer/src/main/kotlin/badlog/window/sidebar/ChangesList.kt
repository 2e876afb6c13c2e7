package badlog.window.sidebar

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import badlog.catalog.folder.LogEntry
import badlog.rules.Finding
import badlog.viewer.shown.folder.Changes
import badlog.window.compare.ComparedRecordings
import badlog.window.findings.LogFindings
import badlog.window.theme.LocalPalette
import badlog.window.theme.Tip

/**
 * What is unlike the matches before, above all findings; a click draws it over the match before. Empty if nothing is, or it is not known.
 *
 * @param onGo called when a click draws something.
 */
@Composable
internal fun ChangesList(changes: Changes<LogEntry>, findings: LogFindings, compared: ComparedRecordings, onGo: () -> Unit) {
    if (changes.differences.isEmpty()) return
    val palette = LocalPalette.current
    Column(
        Modifier
            .fillMaxWidth()
            .padding(horizontal = 8.dp, vertical = 4.dp)
            .background(palette.accentSoft, RoundedCornerShape(4.dp))
            .padding(horizontal = 6.dp, vertical = 4.dp)
            .semantics { contentDescription = Changes.TITLE },
    ) {
        Text(Changes.TITLE, fontWeight = FontWeight.Medium)
        for (difference in changes.differences) {
            Tip(Changes.hintOf(difference)) {
                Text(
                    difference.text,
                    Modifier
                        .fillMaxWidth()
                        .clickable(role = Role.Button) {
                            drawOver(difference, changes, findings, compared)
                            onGo()
                        }
                        .padding(vertical = 2.dp),
                )
            }
        }
    }
}

private fun drawOver(difference: Finding, changes: Changes<LogEntry>, findings: LogFindings, compared: ComparedRecordings) {
    findings.showEvidence(difference)
    changes.previous[difference]?.file?.takeIf { it !in compared.state.checked }?.let(compared::add)
}
