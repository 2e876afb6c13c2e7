package badlog.window

import androidx.compose.ui.window.application
import badlog.files.UserFolders
import badlog.window.app.StartPlace
import badlog.window.app.ViewerWindow
import badlog.window.app.opensClickedFiles
import badlog.window.app.placeSkia
import java.nio.file.Path

/**
 * Opens the window with the folder or file named in [args], or otherwise with the last folder. With [StartPlace.PIT], it begins with the
 * pit view.
 */
fun main(args: Array<String>) {
    placeSkia()
    val samples = System.getProperty("badlog.samples")?.let(Path::of)
    application {
        ViewerWindow(
            folders = UserFolders.ofSystem(),
            start = { viewer ->
                opensClickedFiles(viewer.loader)
                StartPlace.of(args, viewer.settings.state, samples)
            },
        )
    }
}
