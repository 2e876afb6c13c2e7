package badlog.site

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.maps.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import org.jsoup.Jsoup
import java.io.File

class GuideReaderSpec : FunSpec({
    val root = tempdir()

    fun file(path: String, text: String) = File(root, path).apply { parentFile.mkdirs() }.writeText(text)

    fun read(path: String): Guide = GuideReader(root.toPath(), SitePlan(root.toPath())).read(path)

    beforeEach {
        root.listFiles()?.forEach { it.deleteRecursively() }
        for (path in listOf("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "core/conformance/README.md", "gradle/README.md", "samples/README.md")) file(path, "# $path")
    }

    test("links between guides lead to their pages, from any folder to any other") {
        file("docs/page.md", "# Page\n\n## Keys & gestures")
        file("docs/decisions/README.md", "# Decisions\n\nSee [keys](../page.md#keys--gestures), [the front](../../README.md), [samples](../../samples).")
        val html = read("docs/decisions/README.md").html
        html shouldContain """<a href="../page.html#keys--gestures">keys</a>"""
        html shouldContain """<a href="../index.html">the front</a>"""
        html shouldContain """<a href="../samples/index.html">samples</a>"""
        read("docs/page.md").html shouldContain """<h2 id="keys--gestures">"""
    }

    test("a linked file is copied, a picture stays beside its guide, a log becomes its page, and a folder becomes text") {
        file("docs/look.png", "")
        file("vendordep/Badlog.json", "{}")
        file("samples/a.bag.gz", "")
        file("docs/small.png", "")
        file("docs/page.md", "# Page\n\n![a look](look.png) <img src=\"small.png\" width=\"90\"> [vendordep](../vendordep/Badlog.json) [log](../samples/a.bag.gz) [sources](../core)")
        val guide = read("docs/page.md")
        guide.copied shouldContainExactly mapOf("docs/look.png" to "look.png", "docs/small.png" to "small.png", "vendordep/Badlog.json" to "files/vendordep/Badlog.json")
        guide.html shouldContain """href="samples/a.bag.gz.html""""
        guide.html shouldContain "sources</p>"
        guide.html shouldNotContain "../core"
    }

    test("a broken link is reported with its page") {
        file("docs/page.md", "# Page\n\n[gone](gone.md#here)")
        shouldThrow<IllegalStateException> { read("docs/page.md") }.message shouldBe
            "docs/page.md links to “gone.md#here”, which does not exist; correct the link."
    }

    test("a guide without a heading is reported") {
        file("docs/page.md", "Only text.")
        shouldThrow<IllegalStateException> { read("docs/page.md") }.message shouldBe "docs/page.md has no heading; begin it with “# Title”."
    }

    test("sections hold the plain text below each heading") {
        file("docs/page.md", "# The *page*\n\nOne `file`.\n\n## Keys\n\n| a | b |\n|---|---|\n| `?` | help |\n")
        val guide = read("docs/page.md")
        guide.title shouldBe "The page"
        guide.summary shouldBe "One file."
        guide.sections.map { it.anchor } shouldContainExactly listOf("the-page", "keys")
        guide.sections[1].text shouldContain "help"
    }

    test("a flowchart is drawn with all arrows pointing down, and also shown as a list of its arrows") {
        file("docs/page.md", "# Page\n\n```mermaid\nflowchart TD\n    robot[jvm-robot] -- writes bags --> core\n    files --> core\n    files --> robot\n```\n")
        val html = read("docs/page.md").html
        html shouldContain "<li><b>jvm-robot</b> → writes bags <b>core</b></li>\n<li><b>files</b> → <b>core</b>, <b>jvm-robot</b></li>"
        val chart = Jsoup.parse(html).select("figure svg").single()
        chart.select("path.head").size shouldBe 3
        chart.select("text.label").text() shouldBe "writes bags"
        val heights = chart.select("text:not(.label)").associate { it.text() to it.attr("y").toDouble() }
        heights.keys.sortedBy { heights[it] } shouldContainExactly listOf("files", "jvm-robot", "core")
    }

    test("code is shown unchanged") {
        file("docs/page.md", "# Page\n\n```console\n$ badlog find 'a < b & c'\n```\n")
        read("docs/page.md").html shouldContain "<code class=\"language-console\">$ badlog find 'a &lt; b &amp; c'\n</code></pre>"
    }
})
