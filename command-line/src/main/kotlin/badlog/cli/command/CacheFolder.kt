package badlog.cli.command

import java.nio.file.Path

/** Returns the folder for cached results about logs: in the system's folder for files that may be deleted at any time. */
internal fun cacheFolder(
    system: String = System.getProperty("os.name"),
    home: Path = Path.of(System.getProperty("user.home")),
    variable: (String) -> String? = System::getenv,
): Path = when {
    system.startsWith("Windows") -> variable("LOCALAPPDATA")?.let { Path.of(it) } ?: home.resolve("AppData/Local")
    system.startsWith("Mac") -> home.resolve("Library/Caches")
    else -> variable("XDG_CACHE_HOME")?.takeIf { it.isNotBlank() }?.let { Path.of(it) } ?: home.resolve(".cache")
}.resolve("badlog").resolve("answers")
