package badlog.cli.input

import java.nio.file.Path

/** Returns [folder], or the folder of [log] if it is empty. */
internal fun folderBeside(log: Path, folder: Path): Path = if (folder.toString().isEmpty()) log.toAbsolutePath().parent else folder
