package badlog.viewer.compare

import androidx.compose.ui.graphics.Color
import badlog.viewer.theme.Palette

/** The colour of the recording that is number [index] among those drawn, while several are compared. */
internal fun Palette.colorOf(index: Int): Color = line(index)
