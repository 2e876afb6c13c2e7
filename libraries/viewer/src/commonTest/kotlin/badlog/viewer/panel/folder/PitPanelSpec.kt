package badlog.viewer.panel.folder

import badlog.core.recording.Severity
import badlog.signals.battery.BatteryUse
import badlog.signals.battery.Resistance
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.FoundRule
import badlog.viewer.catalog.Verdict
import badlog.viewer.panel.Card
import badlog.viewer.panel.Cards
import badlog.viewer.panel.Paragraph
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.battery.BatterySeason
import badlog.viewer.shown.battery.batteryLog
import badlog.viewer.shown.folder.AnyLog
import badlog.viewer.shown.folder.PitLogs
import badlog.viewer.state.Action
import badlog.viewer.state.FolderAction
import badlog.viewer.state.FolderRequest
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf

class PitPanelSpec : FunSpec({
    val verdict = Verdict(Severity.ERROR, "Browned out at 1:33", listOf("It sagged.", "Then it rebooted."), "Charge the battery.")
    val brownout = FindingSummary(0, listOf(FoundRule("Browned out", Severity.ERROR)), verdict)
    val last = batteryLog(42, BatteryUse("B2", "Battery", 6.73, 12.8, null, null, Resistance(30.0, 0.4))).copy(found = brownout)
    val before = batteryLog(41, BatteryUse("A1", "Battery", 8.5, 12.8, null, null, Resistance(20.0, 0.4))).copy(found = FindingSummary(0, emptyList()))

    fun advice(vararg logs: AnyLog) = BatteryAdvice.of(BatterySeason.of(logs.toList()))
    fun panel(vararg logs: AnyLog, willRead: Boolean = true) = pitPanel(PitLogs.of(logs.toList()), "No log yet.", advice(*logs), Action.Ask(FolderRequest.Batteries), willRead = { willRead })

    test("the last match is first, with its verdict and the next step, and a press shows its worst finding") {
        val parts = panel(last, before)
        parts.filterIsInstance<Paragraph>().first().text shouldBe "Qualification 42"
        val card = parts.filterIsInstance<Card>().first()
        card.run { listOf(headline, "$severity", "$isLarge") } shouldBe listOf("Browned out at 1:33", "ERROR", "true")
        card.lines shouldBe listOf("It sagged.", "Then it rebooted.", "Next: Charge the battery.")
        card.open.shouldBeInstanceOf<FolderAction.Open>().run { path to showsFinding } shouldBe ("/logs/q42.bag" to true)
        card.hint shouldBe "Show what was found in Qualification 42"
    }

    test("batteries follow, then earlier matches beside each other") {
        val parts = panel(last, before)
        parts.filterIsInstance<Card>().drop(1).map { it.title to it.severity } shouldBe listOf("Battery: use A1 next" to null)
        parts.filterIsInstance<Card>().last().open shouldBe Action.Ask(FolderRequest.Batteries)
        val cards = (parts.last() as Cards).cards
        cards.map { listOf(it.title, it.headline, "${it.severity}") } shouldBe listOf(listOf("Qualification 41", "No errors, no warnings", "null"))
    }

    test("a log that must be opened to be read says so") {
        val unread = last.copy(found = null)
        panel(unread, willRead = false).filterIsInstance<Card>().first().run { headline to lines } shouldBe
            ("Not read yet" to listOf("Open it to see what is in it."))
        panel(unread).filterIsInstance<Card>().first().run { headline to lines } shouldBe ("The rules are still running" to emptyList())
    }

    test("without a log, the pit gives the reason") {
        panel().filterIsInstance<Paragraph>().map { it.text } shouldBe listOf("No log yet.")
    }
})
