package badlog.core.conformance

import java.io.File

// Gradle runs the tests of a module in the module's folder.
private val folder = File("conformance")

internal actual fun corpusFileNames(): List<String> = folder.list().orEmpty().sorted()

internal actual fun readCorpusFile(name: String): ByteArray = folder.resolve(name).readBytes()
