package badlog.viewer.session.link

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.session.video.VideoAlignment
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldEndWith
import io.kotest.matchers.string.shouldMatch
import io.kotest.property.Arb
import io.kotest.property.arbitrary.Codepoint
import io.kotest.property.arbitrary.alphanumeric
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.arbitrary.orNull
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import kotlin.math.pow

class PageAddressSpec : FunSpec({
    val name = Arb.choice(Arb.string(0..12), Arb.string(1..8, Codepoint.alphanumeric()), Arb.element("a&b=c", "100%", "#", "A;B", "é\uD800"))
    val board = arbitrary { Arb.list(name, 0..4).bind().fold(Board()) { board, topic -> board.withGraph(listOf(topic, "Other")) } }
    val number = Arb.numericDouble(-1e9, 1e9)
    val address = arbitrary {
        PageAddress(
            moment = number.orNull().bind()?.plus(0.0),
            visible = arbitrary { Span(number.bind() + 0.0, 2e9) }.orNull().bind(),
            board = board.orNull().bind(),
            formulas = Arb.list(name, 0..3).bind().filter { it.isNotEmpty() }.distinct(),
            finding = arbitrary { FindingName(name.bind(), name.orNull().bind()) }.orNull().bind(),
            video = number.orNull().bind()?.let(::VideoAlignment),
            second = number.orNull().bind()?.plus(0.0),
            opened = OpenedParts(name.bind(), Arb.boolean().bind(), Arb.boolean().bind(), Arb.list(Arb.int(1..20), 0..3).bind().distinct()),
        )
    }

    test("an address is read back the same, even if a program escaped its characters differently") {
        checkAll(address) { written ->
            val text = written.toText()
            text shouldMatch Regex("(#[-A-Za-z0-9_./:;,=+~&]+)?")
            val passedOn = text.replace("~", "%7E").replace(";", "%3B").replace("+", "%2b").replace(",", "%2C")
            for (read in listOf(pageAddressOf(text), pageAddressOf(passedOn))) {
                read.moment shouldBe written.moment
                read.visible shouldBe written.visible
                read.board shouldBe written.board
                read.second shouldBe written.second?.takeIf { written.moment != null }
                read.opened shouldBe written.opened
                read.formulas shouldBe written.formulas
                read.finding?.run { rule to topic } shouldBe written.finding?.takeIf { written.moment != null }?.run { rule to topic }
                read.video?.startSeconds shouldBe written.video?.startSeconds?.plus(0.0)
                read.problems shouldBe emptyList()
            }
        }
    }

    test("a link to only a moment, as in older reports, still works") {
        pageAddressOf("#t=93.7").run {
            moment shouldBe 93.7
            (visible == null && this.board == null && formulas.isEmpty() && problems.isEmpty()) shouldBe true
        }
    }

    test("a link of a later version is reported and its known parts are shown; one without a version is of the first") {
        for (text in listOf("#t=93.7&board=Mode", "#version=1&t=93.7&board=Mode")) pageAddressOf(text).problems shouldBe emptyList()
        pageAddressOf("#version=2&t=93.7&board=Mode").run {
            moment shouldBe 93.7
            this.board?.graphs?.map { it.lines } shouldBe listOf(listOf("Mode"))
            problems shouldBe listOf("This link is from a newer badlog; export the log with that one to see all that it shows.")
        }
    }

    test("a link is short enough to read") {
        val two = Board().withGraph(listOf("Battery Voltage")).withGraph(listOf("Mode"))
        PageAddress(93.5, Span(90.5, 100.5), two, listOf("Power = Voltage")).toText() shouldBe
            "#t=93.5&x=90.5:100.5&board=Battery+Voltage;Mode&f=Power+~003d+Voltage"
        PageAddress(93.0, finding = FindingName("Loop stood still", "Loop time")).toText() shouldBe "#t=93&finding=Loop+stood+still;Loop+time"
        PageAddress(93.0, finding = FindingName("Restart", null)).toText() shouldBe "#t=93&finding=Restart"
        PageAddress(video = VideoAlignment(-3.5)).toText() shouldBe "#v=-3.5"
        PageAddress(93.0, second = 95.5, opened = OpenedParts("battery", hasValues = true, statistics = listOf(1, 3))).toText() shouldBe
            "#t=93&b=95.5&q=battery&open=values;1;3"
        PageAddress().toText() shouldBe ""
    }

    // The log is up to a quarter of an hour long. A person puts the cursors anywhere, and zooms to anything between a millisecond and
    // all.
    val looked = arbitrary {
        val width = 10.0.pow(Arb.numericDouble(-3.0, 2.9).bind())
        val from = Arb.numericDouble(0.0, 900.0).bind()
        val places = Arb.numericDouble(from, from + width)
        PageAddress(places.bind(), Span(from, from + width), second = places.orNull().bind()) to width
    }

    test("an unchanged page adds at most 60 characters after the #, which lead to the same place on the screen") {
        checkAll(looked) { (address, width) ->
            val text = address.seenIn(width).toText()
            withClue(text) { text.length shouldBeLessThanOrEqual 61 }
            val read = pageAddressOf(text)
            fun places(of: PageAddress) = listOf(of.moment, of.second, of.visible?.from, of.visible?.to)
            for ((there, here) in places(read) zip places(address)) {
                if (here == null) there shouldBe null else there!! shouldBe (here plusOrMinus width / 10_000)
            }
        }
    }

    test("a board of four topics adds their names and at most 80 characters after the #, and a finding adds its own") {
        val topic = Arb.string(1..40, Codepoint.alphanumeric())
        checkAll(looked, Arb.list(topic, 4..4), topic, topic) { (address, width), topics, rule, about ->
            val names = topics.map { "Drive/$it" }
            val board = names.fold(Board()) { board, name -> board.withGraph(listOf(name)) }
            val link = PageAddress(address.moment, address.visible, board, second = address.second).seenIn(width).toText()
            withClue(link) { link.length shouldBeLessThanOrEqual 81 + names.sumOf { it.length } }
            val finding = FindingName(rule, about)
            val time = (address.moment!! * 1e6).toLong() / 1e6
            val ofFinding = PageAddress(time, address.visible, finding = finding).seenIn(width)
            ofFinding.moment shouldBe time
            withClue(ofFinding.toText()) { ofFinding.toText().length shouldBeLessThanOrEqual 61 + "finding=;&$rule$about".length }
        }
    }

    test("times as logged are unchanged in a link, however small the visible range is") {
        val address = PageAddress(12345.678901, Span(0.02, 149.98), second = -3.0)
        address.seenIn(1000.0).toText() shouldBe address.toText()
    }

    test("each damaged part is reported in a sentence, and the rest is used") {
        pageAddressOf("#t=x&x=5:4&board=~12&f=~zzzz&finding=a;b;c&v=1e999&b=y&q=~1").problems shouldContainExactly
            listOf("time", "range", "board", "formula", "finding", "video’s place", "second cursor", "search").map { "This link’s $it is damaged; copy the link again." }
        pageAddressOf("#t=5&x=").run {
            moment shouldBe 5.0
            problems.size shouldBe 1
        }
    }

    test("a time in a link that is not a number is ignored") {
        for (text in listOf("#t=", "#t=NaN", "#t=Infinity", "#t=-Infinity", "#t=1,5", "#t=%22", "#t=<img src=x>", "#t=1e999", "#x=3")) {
            withClue(text) { pageAddressOf(text).moment shouldBe null }
        }
        pageAddressOf("#t=1e308").moment shouldBe 1e308
        pageAddressOf("#t=-5").moment shouldBe -5.0
    }

    test("anchors of the page and parts of a newer badlog are ignored silently") {
        for (text in listOf("", "#", "#info", "#:~:text=Voltage", "#sound=loud")) {
            pageAddressOf(text).run { (isEmpty && problems.isEmpty()) shouldBe true }
        }
    }

    test("any end of an address is read, and problems are sentences") {
        val pieces = Arb.element("#", "t=", "x=", "board=", "f=", "finding=", "v=", "&", ":", ";", "~", "%", "1e999", "NaN", "-5", "%7E", "y=1", ",")
        val text = Arb.choice(Arb.string(0..40), Arb.list(pieces, 0..20).let { lists -> arbitrary { lists.bind().joinToString("") } })
        checkAll(text, address, Arb.int(0..80)) { some, written, at ->
            for (tried in listOf(some, written.toText().take(at), written.toText().take(at) + some)) {
                for (sentence in pageAddressOf(tried).problems) sentence shouldEndWith "."
            }
        }
    }
})
