package badlog.window.compare

import androidx.compose.ui.graphics.Color
import badlog.window.log.OpenRecording
import badlog.window.theme.Palette

/**
 * A recording that graphs draw.
 *
 * @property offset the number added to its x to align it with the open recording; 0 for the open one.
 * @property name its name beside the other drawn ones.
 */
internal data class DrawnRecording(val recording: OpenRecording, val offset: Double = 0.0, val name: String = recording.label)

/** Returns the color of the drawn recording [index], while several are compared. */
internal fun Palette.colorOf(index: Int): Color = line(index)
