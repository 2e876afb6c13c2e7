package badlog.viewer.playback

import androidx.compose.ui.input.key.Key
import badlog.viewer.app.Command
import badlog.viewer.app.KeyPress
import badlog.viewer.app.Viewer

/** What the keyboard does with playback. */
internal fun playbackCommands(viewer: Viewer): List<Command> = listOf(
    Command(GROUP, "Play or pause", listOf(KeyPress(Key.Spacebar, "Space"))) { togglePlaying(viewer) },
    Command(GROUP, "Loop the selection, or what is seen", listOf(KeyPress(Key.L, "L"))) {
        viewer.playback = viewer.playback.copy(loops = !viewer.playback.loops)
    },
    Command(GROUP, "Slower", listOf(KeyPress(Key.Comma, "<", shift = true), KeyPress(Key.Comma, ","))) {
        viewer.playback = viewer.playback.faster(-1)
    },
    Command(GROUP, "Faster", listOf(KeyPress(Key.Period, ">", shift = true), KeyPress(Key.Period, "."))) {
        viewer.playback = viewer.playback.faster(1)
    },
)

private const val GROUP = "Playback"
