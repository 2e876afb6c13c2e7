package badlog.window.choice

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.files.LogName
import badlog.signals.clock.ClockFit
import badlog.viewer.text.numberText
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import kotlin.math.ceil

/** Offers the Driver Station's log of the same match until a person shows or hides it. While that log is shown, it says so. */
@Composable
internal fun StationOffer(stations: StationChoice) {
    val offered = stations.offered
    val found = offered ?: stations.found?.takeIf { stations.isShown } ?: return
    val name = LogName.of(found.log.name).stem
    val palette = LocalPalette.current
    FlowRow(
        Modifier.fillMaxWidth().background(if (offered == null) palette.surface else palette.accentSoft).padding(start = 12.dp, end = 4.dp),
        itemVerticalAlignment = Alignment.CenterVertically,
    ) {
        val how = alignmentText(found.fit)
        val text = if (offered == null) "With the Driver Station log $name ($how)." else "Driver Station log found: $name ($how)."
        Text(text, Modifier.padding(end = 8.dp, top = 4.dp, bottom = 4.dp), color = if (offered == null) palette.muted else palette.text)
        if (offered == null) {
            ToolButton("Hide the Driver Station log; the menu Layout can show it again", text = "Hide") { stations.choose(false) }
        } else {
            ToolButton("Show its link, power and messages with this log, and use them in rules", text = "Show") { stations.choose(true) }
            ToolButton("Hide it; the menu Layout can show it", text = "Hide") { stations.choose(false) }
        }
    }
}

/** Returns the precision of an alignment: `± 0.02 s`. */
internal fun alignmentText(fit: ClockFit): String {
    // The Driver Station logs every 20 ms: a better precision is impossible.
    val error = ceil(maxOf(fit.error, PERIOD) * HUNDRED) / HUNDRED
    return "± ${numberText(error)} s" + if (fit.edges == 0) ", aligned by the clocks only" else ""
}

private const val PERIOD = 0.02
private const val HUNDRED = 100
