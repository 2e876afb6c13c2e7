package badlog.window.sidebar

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.rules.Finding
import badlog.viewer.choices.board.evidenceOffers
import badlog.viewer.choices.board.with
import badlog.viewer.shown.finding.placeNumber
import badlog.viewer.shown.finding.placesInOrder
import badlog.window.findings.LogFindings
import badlog.window.log.AxisView
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/**
 * The details below the selected [finding]: which of its places is shown and what was found there, buttons for the others, what to look
 * at next, and other topics of [open] to draw beside it.
 */
@Composable
internal fun FindingDetails(
    findings: LogFindings,
    view: AxisView,
    board: GraphBoard,
    open: OpenRecording,
    finding: Finding,
    times: EventTimes,
) {
    val palette = LocalPalette.current
    val places = remember(finding) { finding.placesInOrder }
    if (places.size > 1) {
        val shown by remember(finding, view) { derivedStateOf { maxOf(0, places.indexOfFirst { it.from == view.cursor }) } }
        Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(2.dp), Alignment.CenterVertically) {
            ToolButton("Previous place", Icons.Up, isEnabled = shown > 0) { findings.stepWithin(-1) }
            ToolButton("Next place", Icons.Down, isEnabled = shown < places.lastIndex) { findings.stepWithin(1) }
            Text("${finding.placeNumber(places[shown])}: ${times.logged(places[shown].from)}", color = palette.muted, fontSize = 12.sp)
        }
        Text(finding.textAt(places[shown]), fontSize = 12.sp)
    }
    val next = findings.nextOf(finding)
    if (next.isNotEmpty()) Text("Next: $next", color = palette.muted, fontSize = 12.sp)
    for (caveat in finding.caveats) Text(caveat, color = palette.muted, fontSize = 12.sp)
    val offers = remember(open, board.state) { evidenceOffers(open.view, open.vocabulary, board.evidence) }
    FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(2.dp)) {
        if (board.evidence.graphs.isNotEmpty()) {
            ToolButton("Keep the graphs of this finding on the board", Icons.Pin, text = "Keep") { board.keep() }
        }
        for (offer in offers) {
            ToolButton("Show ${offer.label.lowercase()} beside this finding", Icons.Add, text = offer.label) {
                board.showEvidence(board.evidence.with(offer, open.view, open.vocabulary))
            }
        }
    }
}
