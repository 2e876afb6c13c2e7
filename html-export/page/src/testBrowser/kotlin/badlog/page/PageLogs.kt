package badlog.page

import org.openqa.selenium.chrome.ChromeDriver
import org.openqa.selenium.json.Json
import org.openqa.selenium.logging.LogType
import java.util.logging.Level

/** The browser's logs about a page. */
internal class PageLogs(private val driver: ChromeDriver) {
    /** Drops the entries so far. */
    fun forget() {
        entries(LogType.BROWSER)
        entries(LogType.PERFORMANCE)
    }

    /** Returns the console's warnings and errors since the last call, including those from the browser itself. */
    fun messages(): List<String> = entries(LogType.BROWSER)
        .filter { it.level.intValue() >= Level.WARNING.intValue() }
        .map { it.message }

    /** Returns the addresses requested since the last call. */
    fun requests(): List<String> = entries(LogType.PERFORMANCE).mapNotNull { entry ->
        val event = member(Json().toType<Map<String, Any?>>(entry.message, Json.MAP_TYPE), "message")
        if (event["method"] != "Network.requestWillBeSent") return@mapNotNull null
        member(member(event, "params"), "request")["url"] as String
    }

    private fun entries(type: String) = driver.manage().logs().get(type).all

    @Suppress("UNCHECKED_CAST")
    private fun member(of: Map<String, Any?>, name: String) = of[name] as Map<String, Any?>
}
