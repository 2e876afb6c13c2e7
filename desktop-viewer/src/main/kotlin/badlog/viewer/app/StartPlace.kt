package badlog.viewer.app

import badlog.viewer.settings.Settings
import java.nio.file.Files
import java.nio.file.Path

/**
 * What the window opens on.
 *
 * @property folder the folder whose logs it lists, or null.
 * @property file the log it shows, or null for the newest of [folder].
 * @property complaint why it is not what was asked for, as a sentence, or null.
 */
internal data class StartPlace(val folder: Path?, val file: Path?, val complaint: String?) {
    companion object {
        /**
         * What [argument] names, a folder or a file; without it the folder of last time, and the first time [samples]. What is
         * not there any more is passed over.
         */
        fun of(argument: String?, settings: Settings, samples: Path?): StartPlace {
            val remembered = settings.recentFolders.map { Path.of(it) } + listOfNotNull(samples)
            val folder = remembered.firstOrNull { Files.isDirectory(it) }
            if (argument == null) return StartPlace(folder, null, null)
            val named = Path.of(argument).toAbsolutePath().normalize()
            return when {
                Files.isDirectory(named) -> StartPlace(named, null, null)
                Files.exists(named) -> StartPlace(named.parent, named, null)
                else -> StartPlace(folder, null, "There is no file or folder $named; look for a typing error in its name.")
            }
        }
    }
}
