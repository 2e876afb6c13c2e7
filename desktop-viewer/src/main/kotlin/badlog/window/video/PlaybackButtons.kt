package badlog.window.video

import androidx.compose.foundation.layout.Row
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import badlog.viewer.session.video.VIDEO_SPEEDS
import badlog.viewer.text.exactText
import badlog.window.theme.Icons
import badlog.window.theme.ToolButton

/** The buttons for play, speed and loop; with [hasLabels], each icon has a word beside it. */
@Composable
internal fun PlaybackButtons(player: Player, isEnabled: Boolean, hasLabels: Boolean) {
    val playback = player.state
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton(
            if (playback.isPlaying) "Pause (Space)" else "Play: moves the cursor (Space)",
            if (playback.isPlaying) Icons.Pause else Icons.Play,
            (if (playback.isPlaying) "Pause" else "Play").takeIf { hasLabels },
            isOn = playback.isPlaying,
            isEnabled = isEnabled,
        ) { player.toggle() }
        ToolButton("Slower (<)", text = "‹", isEnabled = playback.speed > VIDEO_SPEEDS.first()) {
            player.change { faster(-1) }
        }
        ToolButton("Speed: ${exactText(playback.speed)} times; click for 1", text = "${exactText(playback.speed)}×") {
            player.change { copy(speed = 1.0) }
        }
        ToolButton("Faster (>)", text = "›", isEnabled = playback.speed < VIDEO_SPEEDS.last()) {
            player.change { faster(1) }
        }
        ToolButton("Loop the selection, or the visible range (L)", Icons.Loop, "Loop".takeIf { hasLabels }, isOn = playback.loops) {
            player.toggleLoop()
        }
    }
}
