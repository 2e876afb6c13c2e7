package badlog.window.findings

import androidx.compose.ui.graphics.Color
import badlog.core.recording.Severity
import badlog.window.theme.Palette

/** Returns the color of the mark for a finding of [severity]. */
internal fun Palette.findingColor(severity: Severity): Color = when (severity) {
    Severity.ERROR -> error
    Severity.WARNING -> warning
    Severity.NOTE -> muted
}

/** Returns the background color of a text about findings of [severity]. */
internal fun Palette.findingSoft(severity: Severity): Color = when (severity) {
    Severity.ERROR -> errorSoft
    Severity.WARNING -> warningSoft
    Severity.NOTE -> raised
}
