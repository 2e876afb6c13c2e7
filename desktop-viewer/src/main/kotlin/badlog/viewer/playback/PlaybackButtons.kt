package badlog.viewer.playback

import androidx.compose.foundation.layout.Row
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import badlog.plot.text.exactText
import badlog.viewer.app.Viewer
import badlog.viewer.theme.Icons
import badlog.viewer.theme.ToolButton

/** Play, speed and loop. */
@Composable
internal fun PlaybackButtons(viewer: Viewer) {
    val playback = viewer.playback
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton(
            if (playback.isPlaying) "Pause (Space)" else "Play: the cursor runs (Space)",
            if (playback.isPlaying) Icons.Pause else Icons.Play,
            isOn = playback.isPlaying,
            isEnabled = viewer.open != null,
        ) { togglePlaying(viewer) }
        ToolButton("Slower (<)", text = "‹", isEnabled = playback.speed > Playback.SPEEDS.first()) {
            viewer.playback = playback.faster(-1)
        }
        ToolButton("Speed: ${exactText(playback.speed)} times; click for 1", text = "${exactText(playback.speed)}×") {
            viewer.playback = playback.copy(speed = 1.0)
        }
        ToolButton("Faster (>)", text = "›", isEnabled = playback.speed < Playback.SPEEDS.last()) {
            viewer.playback = playback.faster(1)
        }
        ToolButton("Loop the selection, or what is seen (L)", Icons.Loop, isOn = playback.loops) {
            viewer.playback = playback.copy(loops = !playback.loops)
        }
    }
}
