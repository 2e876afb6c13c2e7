package badlog.viewer.settings

import androidx.compose.runtime.snapshotFlow
import badlog.viewer.app.Viewer
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.FlowPreview
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.debounce
import kotlinx.coroutines.flow.dropWhile
import kotlinx.coroutines.withContext
import java.io.IOException

/** Writes the settings of [viewer] into [file], which holds [kept], a moment after each change, until cancelled. */
@OptIn(FlowPreview::class)
internal suspend fun keepSettings(viewer: Viewer, file: SettingsFile, kept: Settings) {
    snapshotFlow { viewer.settings }.dropWhile { it == kept }.debounce(QUIET_MILLIS).collectLatest { settings ->
        try {
            withContext(Dispatchers.IO) { file.write(settings) }
        } catch (e: IOException) {
            viewer.notices.complain("Your settings cannot be kept (${e.message}); make room on the disk of your home folder.")
        }
    }
}

private const val QUIET_MILLIS = 400L
