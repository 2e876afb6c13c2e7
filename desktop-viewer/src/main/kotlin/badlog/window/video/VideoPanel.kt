package badlog.window.video

import androidx.compose.foundation.Image
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.aspectRatio
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Slider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.layout.ContentScale
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import badlog.viewer.session.video.VIDEO_SPEEDS
import badlog.viewer.session.video.VideoAlignment
import badlog.viewer.session.video.alignmentHint
import badlog.viewer.text.exactText
import badlog.window.log.OpenRecording
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.NameText
import badlog.window.theme.ToolButton
import java.util.Locale

/** The video beside [open], and the buttons that align it. */
@Composable
internal fun VideoPanel(video: LogVideo, open: OpenRecording, modifier: Modifier = Modifier) {
    Column(modifier) {
        val shown = video.state
        val file = shown.file
        if (video.secondsOfX == null) {
            Hint(VideoAlignment.NO_TIME)
            return@Column
        }
        Row(Modifier.fillMaxWidth().padding(start = 12.dp, end = 4.dp), verticalAlignment = Alignment.CenterVertically) {
            NameText(
                file?.fileName?.toString() ?: "No video",
                Modifier.weight(1f),
                fontWeight = FontWeight.Medium,
                cut = NameCut.MIDDLE,
            )
            ToolButton("Open a video", Icons.Folder, onClick = video::askForVideo)
            if (file != null) ToolButton("Close the video", Icons.Close, onClick = video::close)
        }
        when {
            file == null -> Hint(
                "Drop a video of the match here, or open one. It can be of any length, and begin before the log or after it.",
            )

            shown.problem != null -> Hint(shown.problem)

            shown.frame == null -> Hint("Opening the video…")

            else -> ShownFrame(video, shown, shown.frame, open.enabled.isNotEmpty())
        }
    }
}

@Composable
private fun ColumnScope.ShownFrame(video: LogVideo, shown: ShownVideo, frame: VideoFrame, hasEnabled: Boolean) {
    Image(
        frame.image,
        "Video at ${secondsText(frame.time)}",
        // As wide as the panel, unless the controls below would not fit.
        Modifier.weight(1f, fill = false).aspectRatio(frame.image.width.toFloat() / frame.image.height).align(Alignment.CenterHorizontally),
        contentScale = ContentScale.FillBounds,
    )
    if (shown.duration > 0) {
        Slider(
            frame.time.toFloat(),
            { video.seek(it.toDouble()) },
            Modifier.fillMaxWidth().padding(horizontal = 12.dp).semantics { contentDescription = "Position in the video" },
            valueRange = 0f..shown.duration.toFloat(),
        )
    }
    FlowRow(Modifier.padding(horizontal = 4.dp), itemVerticalAlignment = Alignment.CenterVertically) {
        ToolButton("Previous frame (,)", Icons.PreviousFrame) { video.step(-1) }
        ToolButton("Next frame (.)", Icons.NextFrame) { video.step(1) }
        Text(secondsText(frame.time), Modifier.padding(horizontal = 6.dp), color = LocalPalette.current.muted)
        if (hasEnabled) {
            ToolButton("The robot is enabled in this frame", text = "Enabled here", onClick = video::alignEnabled)
        }
        ToolButton("Link video and cursor", Icons.Link, isOn = shown.alignment != null, onClick = video::toggleLink)
    }
    if (shown.alignment == null) Hint(alignmentHint(hasEnabled))
}

@Composable
private fun Hint(text: String) {
    Text(text, Modifier.padding(12.dp), color = LocalPalette.current.muted)
}

/** Returns [seconds] from the start of the video as text, such as `1:23.467`. */
internal fun secondsText(seconds: Double): String {
    val millis = Math.round(maxOf(0.0, seconds) * MILLIS)
    return String.format(Locale.ROOT, "%d:%02d.%03d", millis / MINUTE, millis / MILLIS % SECONDS, millis % MILLIS)
}

private const val MILLIS = 1000L
private const val SECONDS = 60
private const val MINUTE = MILLIS * SECONDS

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
