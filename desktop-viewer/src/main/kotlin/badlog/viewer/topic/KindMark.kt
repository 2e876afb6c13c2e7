package badlog.viewer.topic

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Icon
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.recording.Signal
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette

/** What sort of signal it is, or the colour of its line where one is drawn at [place] of a graph. */
@Composable
internal fun KindMark(signal: Signal, isEvents: Boolean, place: Int?) {
    val palette = LocalPalette.current
    Box(Modifier.size(14.dp), Alignment.Center) {
        if (place != null) {
            Box(Modifier.size(10.dp).background(palette.line(place), RoundedCornerShape(2.dp)))
        } else {
            val icon = when {
                isEvents -> Icons.Flag
                signal.definition != null -> Icons.Formula
                signal.states != null -> Icons.Lanes
                else -> Icons.Wave
            }
            Icon(icon, contentDescription = null, Modifier.size(13.dp), palette.muted)
        }
    }
}
