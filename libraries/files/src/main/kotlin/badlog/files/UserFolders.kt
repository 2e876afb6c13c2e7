package badlog.files

import java.nio.file.Path

/**
 * The folders of badlog's programs for the user's own files.
 *
 * @property settings the folder of settings, which should be kept.
 * @property cache the folder of cached results, which may be deleted at any time.
 */
public class UserFolders(public val settings: Path, public val cache: Path) {
    /** The folder of stored answers about logs, which all programs share. */
    public val answers: Path get() = cache.resolve("answers")

    public companion object {
        /** Returns the system's usual folders: XDG's on Linux, `Library` on macOS, `AppData` on Windows. */
        public fun ofSystem(
            system: String = System.getProperty("os.name"),
            user: Path = Path.of(System.getProperty("user.home")),
            variable: (String) -> String? = System::getenv,
        ): UserFolders {
            // XDG requires relative paths to be ignored.
            fun named(name: String, otherwise: Path) =
                variable(name)?.takeIf { it.isNotBlank() }?.let(Path::of)?.takeIf { it.isAbsolute } ?: otherwise
            // Java takes it from the system's list of users, whatever HOME says.
            val home = if (system.startsWith("Windows")) user else named("HOME", user)
            return when {
                system.startsWith("Windows") -> UserFolders(
                    settings = named("APPDATA", home.resolve("AppData/Roaming")).resolve(NAME),
                    cache = named("LOCALAPPDATA", home.resolve("AppData/Local")).resolve(NAME).resolve("cache"),
                )

                system.startsWith("Mac") -> UserFolders(
                    settings = home.resolve("Library/Application Support").resolve(NAME),
                    cache = home.resolve("Library/Caches").resolve(NAME),
                )

                else -> UserFolders(
                    settings = named("XDG_CONFIG_HOME", home.resolve(".config")).resolve(NAME),
                    cache = named("XDG_CACHE_HOME", home.resolve(".cache")).resolve(NAME),
                )
            }
        }

        private const val NAME = "badlog"
    }
}
