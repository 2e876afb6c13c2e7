package badlog.networktables.replay

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

private fun read(text: String, ignored: MutableList<String> = ArrayList()) = RequestReader { ignored += it }.read(text)

private val PIECES = listOf(
    "[", "]", "{", "}", ",", ":", "\"", "\\", "\"method\"", "\"params\"", "\"subscribe\"", "\"publish\"", "\"topics\"", "\"subuid\"",
    "\"options\"", "null", "true", "1", "-1e999", "99999999999999999999", " ", "\u0000",
)

class RequestReaderSpec : FunSpec({
    test("a subscription without options selects whole names and the latest value of each tenth of a second") {
        val request = read("""[{"method":"subscribe","params":{"topics":["/A","/B"],"subuid":-3}}]""").single()
        request.shouldBeInstanceOf<Request.Subscribe>()
        request.id shouldBe -3
        request.names shouldBe listOf("/A", "/B")
        request.periodMicros shouldBe 100_000
        listOf(request.isAll, request.isPrefix, request.isTopicsOnly) shouldBe listOf(false, false, false)
    }

    test("known options of a subscription apply, and unknown ones are ignored") {
        val request = read(
            """[{"method":"subscribe","params":{"topics":[""],"subuid":1,
            "options":{"periodic":0.02,"all":true,"prefix":true,"topicsonly":true,"color":"red"}}}]""",
        ).single()
        request.shouldBeInstanceOf<Request.Subscribe>()
        request.periodMicros shouldBe 20_000
        listOf(request.isAll, request.isPrefix, request.isTopicsOnly) shouldBe listOf(true, true, true)
    }

    test("unknown requests are skipped and reported, and the others apply") {
        val ignored = ArrayList<String>()
        val requests = read(
            """[1,{"method":"dance","params":{}},{"method":"unsubscribe","params":{}},{"method":3,"params":{}},
            {"method":"subscribe","params":{"topics":[1],"subuid":1}},{"method":"unsubscribe","params":{"subuid":7}}]""",
            ignored,
        )
        (requests.single() as Request.Unsubscribe).id shouldBe 7
        ignored.size shouldBe 5
    }

    test("a frame that is not a list of messages is reported") {
        for (text in listOf("", "[", "{}", "[{]", "[".repeat(1_000_000), "{\"a\":".repeat(1_000_000))) {
            val ignored = ArrayList<String>()
            read(text, ignored).shouldBeEmpty()
            ignored.size shouldBe 1
        }
    }

    test("any text is read without an exception") {
        checkAll(Arb.list(Arb.element(PIECES), 0..40)) { read(it.joinToString("")) }
        checkAll(Arb.string()) { read(it) }
    }
})
