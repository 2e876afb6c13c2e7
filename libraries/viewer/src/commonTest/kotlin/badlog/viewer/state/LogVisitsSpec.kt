package badlog.viewer.state

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

internal class LogVisitsSpec : FunSpec({
    val opened = LogVisits().showing(Visit.LIST).showing(Visit.LOG)

    fun LogVisits.place() = at to now

    fun LogVisits.to(place: Int, without: Visit? = null) = returned(place) { it != without }?.place()

    test("a list and a log of it are an entry each, to which Back and Forward return") {
        opened.place() shouldBe (2 to Visit.LOG)
        opened.to(1) shouldBe (1 to Visit.LIST)
        opened.to(0) shouldBe (0 to Visit.START)
        opened.returned(0) { true }!!.to(2) shouldBe (2 to Visit.LOG)
    }

    test("the next log of the list takes the entry of the log before it, so that Back leads to the list") {
        opened.showing(Visit.LOG).place() shouldBe (2 to Visit.LOG)
    }

    test("the button that leads back goes to the entry of the list, from which Forward leads to the log") {
        val listed = opened.showing(Visit.LIST)
        listed.place() shouldBe (1 to Visit.LIST)
        listed.to(2) shouldBe (2 to Visit.LOG)
        opened.showing(Visit.START).place() shouldBe (0 to Visit.START)
    }

    test("a link within a log is one more entry of it, and the button leads back past both") {
        val linked = opened.again()
        linked.place() shouldBe (3 to Visit.LOG)
        linked.to(2) shouldBe (2 to Visit.LOG)
        linked.showing(Visit.LOG).place() shouldBe (3 to Visit.LOG)
        linked.showing(Visit.LIST).place() shouldBe (1 to Visit.LIST)
    }

    test("another log after Back ends the way forward") {
        opened.showing(Visit.START).showing(Visit.LOG).run {
            place() shouldBe (1 to Visit.LOG)
            to(2) shouldBe null
        }
    }

    test("a folder that is dropped on a log without a list takes its entry") {
        val listed = LogVisits().showing(Visit.LOG).showing(Visit.LIST)
        listed.place() shouldBe (1 to Visit.LIST)
        listed.showing(Visit.LOG).to(1) shouldBe (1 to Visit.LIST)
    }

    test("Back leads to the start if the list no longer exists, and to the list if the log no longer exists") {
        opened.to(1, without = Visit.LIST) shouldBe (1 to Visit.START)
        opened.to(2, without = Visit.LOG) shouldBe (2 to Visit.LIST)
        opened.returned(1) { it != Visit.LIST }!!.showing(Visit.LIST).place() shouldBe (2 to Visit.LIST)
    }

    test("entries that the page did not make, as those from before it was loaded again, change nothing") {
        opened.to(3) shouldBe null
        LogVisits().to(-1) shouldBe null
    }
})
