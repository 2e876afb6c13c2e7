package badlog.window.theme

import androidx.compose.foundation.LocalScrollbarStyle
import androidx.compose.foundation.defaultScrollbarStyle
import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.material3.LocalContentColor
import androidx.compose.material3.LocalTextStyle
import androidx.compose.material3.MaterialTheme
import androidx.compose.material3.darkColorScheme
import androidx.compose.material3.lightColorScheme
import androidx.compose.runtime.Composable
import androidx.compose.runtime.CompositionLocalProvider
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import kotlinx.serialization.Serializable

/** The color theme of the window. */
@Serializable
internal enum class Theme {
    SYSTEM,
    LIGHT,
    DARK,
    ;

    /**
     * Returns the theme after a click, which always has the opposite of the visible colors. It is [SYSTEM] if the system has these opposite
     * colors: dark if [isSystemDark].
     */
    fun other(isSystemDark: Boolean): Theme {
        val wantsDark = when (this) {
            SYSTEM -> !isSystemDark
            LIGHT -> true
            DARK -> false
        }
        return when {
            wantsDark == isSystemDark -> SYSTEM
            wantsDark -> DARK
            else -> LIGHT
        }
    }
}

/** Shows [content] in the colors of [theme] and with small text, so that more fits on the screen. */
@Composable
internal fun ViewerTheme(theme: Theme, content: @Composable () -> Unit) {
    val isDark = when (theme) {
        Theme.LIGHT -> false
        Theme.DARK -> true
        Theme.SYSTEM -> isSystemInDarkTheme()
    }
    val palette = if (isDark) Palette.DARK else Palette.LIGHT
    val scheme = (if (isDark) darkColorScheme() else lightColorScheme()).copy(
        primary = palette.accent,
        onPrimary = palette.surface,
        secondaryContainer = palette.accentSoft,
        onSecondaryContainer = palette.text,
        background = palette.page,
        onBackground = palette.text,
        surface = palette.surface,
        onSurface = palette.text,
        onSurfaceVariant = palette.muted,
        surfaceContainer = palette.raised,
        surfaceContainerHigh = palette.raised,
        surfaceContainerHighest = palette.raised,
        outline = palette.border,
        outlineVariant = palette.border,
        error = palette.error,
    )
    MaterialTheme(colorScheme = scheme) {
        CompositionLocalProvider(
            LocalPalette provides palette,
            LocalContentColor provides palette.text,
            LocalTextStyle provides TextStyle(color = palette.text, fontSize = 13.sp, lineHeight = 18.sp),
            LocalScrollbarStyle provides defaultScrollbarStyle().copy(
                thickness = 8.dp,
                unhoverColor = palette.muted.copy(alpha = 0.3f),
                hoverColor = palette.muted.copy(alpha = 0.6f),
            ),
            content = content,
        )
    }
}
