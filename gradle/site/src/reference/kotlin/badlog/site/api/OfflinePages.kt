package badlog.site.api

import java.io.File

/**
 * Makes Dokka's pages in [folder] work from disk. They fetch their navigation and the search's list of pages, which browsers forbid for
 * pages on disk. A script contains both, and answers those requests.
 */
internal fun makeOffline(folder: File) {
    val carried = FETCHED.map { name -> name to File(folder, name) }.filter { (_, file) -> file.exists() }
    val answers = carried.joinToString(",\n") { (name, file) -> "${quoted(name)}: ${quoted(file.readText())}" }
    File(folder, SCRIPT).writeText(
        """
        |(() => {
        |const carried = {
        |$answers
        |};
        |const fetched = window.fetch;
        |window.fetch = (address, ...more) => {
        |  const name = Object.keys(carried).find(name => String(address).endsWith(name));
        |  return name ? Promise.resolve(new Response(carried[name])) : fetched(address, ...more);
        |};
        |})();
        |
        """.trimMargin(),
    )
    for (page in folder.walk().filter { it.isFile && it.extension == "html" && it.name != "navigation.html" }) {
        val depth = page.relativeTo(folder).invariantSeparatorsPath.count { it == '/' }
        val text = page.readText().replace(REMOTE_SCRIPTS, "").replace("\"$HOME\"", "\"${"../".repeat(depth + 1)}index.html\"")
        page.writeText(text.replaceFirst("<head>", "<head><script src=\"${"../".repeat(depth)}$SCRIPT\"></script>"))
    }
}

private fun quoted(text: String): String =
    text.replace("\\", "\\\\").replace("\"", "\\\"").replace("\r", "").replace("\n", "\\n").replace("</", "<\\/").let { "\"$it\"" }

/** A placeholder for the link to the guides: Dokka writes the same link on every page, in any folder. */
internal const val HOME = "badlog-guides"

/** Scripts from other servers, on which Dokka's pages can run Kotlin. */
private val REMOTE_SCRIPTS = Regex("""<script[^>]* src="https?:[^>]*></script>\s*""")

private const val SCRIPT = "scripts/carried.js"
private val FETCHED = listOf("navigation.html", "scripts/pages.json")
