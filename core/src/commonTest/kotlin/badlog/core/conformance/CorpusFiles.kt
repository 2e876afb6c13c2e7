package badlog.core.conformance

/** The names of all files in `core/conformance`. */
internal expect fun corpusFileNames(): List<String>

/** The bytes of the file [name] in `core/conformance`. */
internal expect fun readCorpusFile(name: String): ByteArray
