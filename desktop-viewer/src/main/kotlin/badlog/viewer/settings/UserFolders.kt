package badlog.viewer.settings

import java.nio.file.Path
import java.security.MessageDigest
import java.util.HexFormat

/**
 * Where the viewer keeps what is the user's own.
 *
 * @property settings what a person has chosen; to be kept.
 * @property cache what can be found out again; may be deleted at any time.
 */
internal class UserFolders(val settings: Path, val cache: Path) {
    companion object {
        /** The folders that the system means for it: XDG's on Linux, `Library` on macOS, `AppData` on Windows. */
        fun ofSystem(
            system: String = System.getProperty("os.name"),
            user: Path = Path.of(System.getProperty("user.home")),
            variable: (String) -> String? = System::getenv,
        ): UserFolders {
            // XDG has relative paths ignored.
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

/** A name for a file of what is kept about [folder]: its path may be longer than a file's name can be. */
internal fun keyOf(folder: Path): String {
    val path = folder.toAbsolutePath().normalize().toString()
    val digest = MessageDigest.getInstance("SHA-256").digest(path.encodeToByteArray())
    return HexFormat.of().formatHex(digest, 0, BYTES)
}

private const val BYTES = 16
