package badlog.viewer

import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberCoroutineScope
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import androidx.compose.ui.window.Window
import androidx.compose.ui.window.application
import androidx.compose.ui.window.rememberWindowState
import badlog.viewer.app.Viewer
import badlog.viewer.app.ViewerScreen
import badlog.viewer.settings.SettingsFile
import badlog.viewer.settings.UserFolders

/** Opens the window on the folder or file that [args] names. */
@Suppress("UNUSED_PARAMETER")
fun main(args: Array<String>) {
    val folders = UserFolders.ofSystem()
    val settings = SettingsFile(folders.settings.resolve("settings.json")).read()
    application {
        val scope = rememberCoroutineScope()
        val viewer = remember { Viewer(scope, folders, settings) }
        Window(
            onCloseRequest = ::exitApplication,
            state = rememberWindowState(size = DpSize(1400.dp, 860.dp)),
            title = viewer.open?.label?.let { "$it – badlog" } ?: "badlog",
        ) {
            ViewerScreen(viewer)
        }
    }
}
