package badlog.site

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.jsoup.nodes.Document
import java.net.URLDecoder
import java.nio.file.Path
import kotlin.io.path.exists

private val ROOT = Path.of("../..").toRealPath()

private val OUTSIDE = Regex("^(https?|mailto|data|blob|javascript):|^//")

@Tags("InCheck")
class SiteSpec : FunSpec({
    val plan = SitePlan(ROOT)

    /** Returns the broken links of [page] at [address], in words. */
    fun brokenLinks(address: String, page: Document): List<String> {
        val links = page.select("a[href], link[href]").map { it.attr("href") } + page.select("img[src], script[src], iframe[src]").map { it.attr("src") }
        return links.filter { it.isNotBlank() && !OUTSIDE.containsMatchIn(it) }.distinct().mapNotNull { link ->
            val file = link.substringBefore('#').substringBefore('?')
            val target = if (file.isEmpty()) address else resolve(address.substringBeforeLast('/', ""), URLDecoder.decode(file.replace("+", "%2B"), Charsets.UTF_8))
            val anchor = URLDecoder.decode(link.substringAfter('#', "").replace("+", "%2B"), Charsets.UTF_8)
            when {
                !BuiltSite.folder.resolve(target).exists() -> "$address: $link"

                // Exported pages interpret the part after # themselves.
                anchor.isEmpty() || target.startsWith("samples/") || target.startsWith("report/") || target.startsWith("api/") -> null

                target !in BuiltSite.pages -> null

                BuiltSite.pages.getValue(target).getElementById(anchor) == null -> "$address: $link"

                else -> null
            }
        }
    }

    test("every link, picture, script and anchor of the site exists") {
        BuiltSite.pages.size shouldBeGreaterThan plan.pages.size
        BuiltSite.pages.flatMap { (address, page) -> brokenLinks(address, page) }.joinToString("\n") shouldBe ""
    }

    test("the guides load no files from other sites") {
        plan.pages.values.flatMap { address ->
            BuiltSite.pages.getValue(address).select("script[src], img[src], iframe[src], link[rel=stylesheet]")
                .map { it.attr("src") + it.attr("href") }.filter { OUTSIDE.containsMatchIn(it) }
        }.shouldBeEmpty()
    }

    test("every guide is in the list of contents, once") {
        val listed = BuiltSite.pages.getValue("index.html").select("nav.contents a").map { it.attr("href") }
        listed.groupBy { it }.filterValues { it.size > 1 }.keys.shouldBeEmpty()
        val decisions = plan.pages.filterKeys { it.startsWith("docs/decisions/") && !it.endsWith("README.md") }.values
        (plan.pages.values - decisions.toSet() - setOf("index.html", "guides.html") - listed.toSet()).shouldBeEmpty()
    }

    test("every decision is in the list of decisions") {
        val listed = BuiltSite.pages.getValue("decisions/index.html").select("main a").map { "decisions/" + it.attr("href") }
        listed shouldContainAll plan.pages.filterKeys { it.startsWith("docs/decisions/") && !it.endsWith("README.md") }.values
    }

    test("the samples, a report on them and the API are part of the site") {
        for (address in listOf("samples/qualification-42.bag.html", "report/index.html", "api/index.html")) {
            BuiltSite.folder.resolve(address).exists() shouldBe true
        }
    }

    test("a link to a sample leads to its page") {
        BuiltSite.pages.getValue("guides.html").select("nav.contents a").map { it.attr("href") } shouldContainAll
            listOf("samples/index.html", "samples/qualification-42.bag.html", "report/index.html", "api/index.html")
    }

    test("the search finds a guide from disk, by a heading and by a misspelled word").config(enabledOrReasonIf = { BuiltSite.browser }) {
        val byHeading = BuiltSite.inBrowser("robot.html?q=power+cut").select(".results a")
        byHeading.map { it.attr("href") } shouldContainAll listOf("robot.html#what-survives")
        BuiltSite.inBrowser("decisions/index.html?q=brownuot").select(".results a").map { it.attr("href") }.any { it.startsWith("../") } shouldBe true
        BuiltSite.inBrowser("index.html?q=xyzzyqqq").select(".results").text() shouldContain "Nothing found"
    }

    test("the search finds a type of the API").config(enabledOrReasonIf = { BuiltSite.browser }) {
        val found = BuiltSite.inBrowser("index.html?q=BagParser").select(".results a").map { it.attr("href") }
        found.any { it.startsWith("api/") && it.endsWith("/-bag-parser/index.html") } shouldBe true
    }

    test("the API's pages show their navigation from disk").config(enabledOrReasonIf = { BuiltSite.browser }) {
        BuiltSite.inBrowser("api/index.html").select("#sideMenu a").map { it.text() } shouldContainAll listOf("badlog.core.bag")
    }
})
