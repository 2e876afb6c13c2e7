package badlog.page

import badlog.exporter.HtmlExporter
import badlog.protocol.PageAdditions
import java.nio.file.Files
import java.nio.file.Path

/** The samples of this repository. */
internal val SAMPLES: Path = Path.of("../../samples")

/** The pages of the tests, made as a user makes them. */
internal object TestPages {
    private val folder = Files.createTempDirectory("badlog-pages").also { folder ->
        Runtime.getRuntime().addShutdownHook(Thread { folder.toFile().deleteRecursively() })
    }
    private val exporter by lazy { HtmlExporter() }
    private val samples = HashMap<String, Path>()
    private var count = 0

    /** Returns the page of the sample [name]. */
    fun ofSample(name: String): Path = samples.getOrPut(name) { ofFile(SAMPLES.resolve(name)) }

    /** Returns the page of a file with these [bytes] and this [name], with [additions]. */
    fun of(bytes: ByteArray, name: String = "test.bag", additions: PageAdditions = PageAdditions()): Path {
        val file = Files.createDirectory(folder.resolve("${count++}")).resolve(name)
        return ofFile(Files.write(file, bytes), additions)
    }

    /** Returns the page of a bag with these [bytes], with the [video] in the file [name] beside it. */
    fun withVideo(bytes: ByteArray, name: String, video: ByteArray): Path {
        val beside = Files.createDirectory(folder.resolve("${count++}"))
        Files.write(beside.resolve(name), video)
        val log = Files.write(beside.resolve("test.bag"), bytes)
        return beside.resolve("page.html").also { exporter.export(log, it, PageAdditions(video = name)) }
    }

    /** Returns the page of the log in the file [first], which has the file [second] beside it. */
    fun ofPair(first: Pair<String, ByteArray>, second: Pair<String, ByteArray>): Path {
        val beside = Files.createDirectory(folder.resolve("${count++}"))
        return listOf(second, first).map { (name, bytes) -> Files.write(beside.resolve(name), bytes) }.last().let { ofFile(it) }
    }

    /** Returns the page of the sample [name] with [additions]. */
    fun ofSample(name: String, additions: PageAdditions): Path = ofFile(SAMPLES.resolve(name), additions)

    /** Returns the page of the sample [name] that compares it with the samples [others]. */
    fun ofSamples(name: String, others: List<String>): Path = folder.resolve("page-${count++}.html").also { page ->
        HtmlExporter(compared = others.map(SAMPLES::resolve)).export(SAMPLES.resolve(name), page)
    }

    /** Returns the page of a file with this [text]. */
    fun of(text: String, name: String = "test.bag"): Path = of(text.encodeToByteArray(), name)

    private fun ofFile(file: Path, additions: PageAdditions = PageAdditions()): Path {
        val page = folder.resolve("page-${count++}.html")
        exporter.export(file, page, additions)
        return page
    }
}
