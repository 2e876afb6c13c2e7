package badlog.site

import io.kotest.core.test.Enabled
import org.jsoup.Jsoup
import org.jsoup.nodes.Document
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.extension
import kotlin.io.path.readText
import kotlin.io.path.walk

/** The site made by the build. */
internal object BuiltSite {
    val folder: Path = Path.of(System.getProperty("badlog.site"))

    /** All pages by address, parsed. */
    val pages: Map<String, Document> by lazy {
        folder.walk().filter { it.extension == "html" }
            .associate { file -> folder.relativize(file).joinToString("/") to Jsoup.parse(file.readText()) }
    }

    private val chromium = System.getenv("PATH").orEmpty().split(File.pathSeparator)
        .flatMap { folder -> listOf("chromium", "chromium-browser", "google-chrome").map { Path.of(folder, it) } }.firstOrNull(Files::isExecutable)

    /** Enabled if there is a browser; otherwise the reason says that the test needs one. */
    val browser: Enabled =
        if (chromium != null || System.getenv("BADLOG_BROWSER") == "required") Enabled.enabled else Enabled.disabled("Chromium is missing on the PATH")

    /** Returns the document at [address] in a browser, opened from disk, after its scripts have run. */
    fun inBrowser(address: String): Document {
        val profile = Files.createTempDirectory("badlog-site")
        try {
            val program = ProcessBuilder(
                checkNotNull(chromium) { "BADLOG_BROWSER=required, but Chromium is not on the PATH." }.toString(),
                "--headless=new",
                "--no-sandbox",
                "--disable-gpu",
                "--user-data-dir=$profile",
                "--virtual-time-budget=20000",
                "--dump-dom",
                folder.toUri().toString().removeSuffix("/") + "/" + address,
            ).redirectError(ProcessBuilder.Redirect.DISCARD).start()
            val shown = program.inputStream.readAllBytes().decodeToString()
            check(program.waitFor(5, TimeUnit.MINUTES)) { "Chromium does not end." }
            return Jsoup.parse(shown)
        } finally {
            profile.toFile().deleteRecursively()
        }
    }
}
