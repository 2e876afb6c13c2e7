package badlog.report

import badlog.files.LogFile
import java.io.File
import java.nio.file.Path

internal val ROOT: File = generateSequence(File("").absoluteFile) { it.parentFile }.first { File(it, "docs/rules.md").exists() }

internal val SAMPLES: List<LogFile> by lazy { logsIn(File(ROOT, "samples").toPath()) }

internal fun sample(name: String): Path = File(ROOT, "samples/$name").toPath()
