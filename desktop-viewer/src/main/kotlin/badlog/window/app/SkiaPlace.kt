package badlog.window.app

import badlog.window.files.obstacleTo
import java.nio.file.Files
import java.nio.file.Path

/**
 * Makes Skia unpack its native library into a temporary folder if [home] cannot be written. Without the library, no window opens. Call it
 * before anything is drawn. Windows does not delete a loaded library, so the folder stays there until temporary files are removed.
 */
internal fun placeSkia(home: Path = Path.of(System.getProperty("user.home"))) {
    if (System.getProperty(PLACE) != null || obstacleTo(home.resolve(".skiko")) == null) return
    // A folder of this run only: in one with a known name, another user could put another library.
    val folder = Files.createTempDirectory("badlog-skia")
    Runtime.getRuntime().addShutdownHook(Thread { folder.toFile().deleteRecursively() })
    System.setProperty(PLACE, "$folder")
}

private const val PLACE = "skiko.data.path"
