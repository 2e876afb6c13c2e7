package badlog.page.browser

import org.openqa.selenium.bidi.Connection
import org.openqa.selenium.remote.http.ClientConfig
import org.openqa.selenium.remote.http.HttpClient
import java.net.URI
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import kotlin.concurrent.thread

internal const val FIREFOX_PROGRAM = "firefox-esr"

/** Starts Firefox without a window, with its own [profile]. */
internal fun firefoxTab(profile: Path, downloads: Path): BrowserTab {
    Files.createDirectories(profile)
    Files.writeString(
        profile.resolve("user.js"),
        """
        user_pref("browser.download.folderList", 2);
        user_pref("browser.download.dir", "$downloads");
        user_pref("browser.shell.checkDefaultBrowser", false);
        user_pref("datareporting.policy.dataSubmissionEnabled", false);
        """.trimIndent(),
    )
    val firefox = program(FIREFOX_PROGRAM, "--headless", "--no-remote", "--profile", "$profile", "--remote-debugging-port=0").start()
    val lines = firefox.errorReader()
    val address = generateSequence { lines.readLine() }.firstNotNullOf { Regex("""BiDi listening on (ws://\S+)""").find(it) }.groupValues[1] + "/session"
    // A full pipe would block it.
    thread(isDaemon = true) { lines.forEachLine { } }
    val client = HttpClient.Factory.createDefault().createClient(ClientConfig.defaultConfig().baseUri(URI(address)).connectionTimeout(Duration.ofMinutes(2)))
    return BidiTab(Connection(client, address)) { firefox.end() }
}
