package badlog.exporter

/** The version of badlog that makes the pages, such as `3.0.0`. */
val BADLOG_VERSION: String by lazy {
    val stream = PageParts::class.java.getResourceAsStream("/badlog/exporter/version.txt")
    checkNotNull(stream) { "The version is missing in this build of badlog." }
    stream.use { it.readBytes().decodeToString().trim() }
}
