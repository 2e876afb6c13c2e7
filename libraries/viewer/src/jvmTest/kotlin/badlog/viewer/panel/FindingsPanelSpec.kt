package badlog.viewer.panel

import badlog.core.analysis.Span
import badlog.core.analysis.XAxis
import badlog.core.recording.Severity
import badlog.rules.BUILT_IN_PROVEN
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.SkippedRule
import badlog.rules.incident.incidentsIn
import badlog.signals.logging.LoggingLibrary
import badlog.viewer.bagView
import badlog.viewer.choices.board.EvidenceOffer
import badlog.viewer.panel.finding.FindingDetails
import badlog.viewer.panel.finding.FindingsShown
import badlog.viewer.panel.finding.findingsPanel
import badlog.viewer.panel.finding.isFixed
import badlog.viewer.shown.finding.RuleResults
import badlog.viewer.shown.finding.firstPlace
import badlog.viewer.state.Action
import badlog.viewer.state.FindingAction
import badlog.viewer.state.FindingRequest
import badlog.viewer.state.FindingsState
import badlog.viewer.state.FolderRequest
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoList
import badlog.viewer.todo.taskOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldBeUnique
import io.kotest.matchers.equality.shouldBeEqualToComparingFields
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe

class FindingsPanelSpec : FunSpec({
    infix fun Action?.shouldSend(other: Action) = checkNotNull(this).shouldBeEqualToComparingFields(other)

    fun found(rule: String, severity: Severity, vararg spans: Span, next: String = "", caveats: List<String> = emptyList()) = Finding(rule, severity, null, "$rule was seen.", spans.firstOrNull()?.from ?: Double.NaN, spans.toList(), spans.size, "s", evidence = listOf("A"), next = next, caveats = caveats)

    val times = LogTimes(100.0, bagView(listOf("Time|xaxis", "A"), listOf("0,1", "100,1")).xAxis, emptyList())
    val early = found("Early", Severity.ERROR, Span(10.0, 12.5))
    val late = found("Late", Severity.NOTE, Span(80.0, 80.0))
    val whole = found("Whole", Severity.WARNING)
    val some = RuleResults(listOf(early, late, whole), ran = 3)

    fun shown(found: RuleResults? = some, state: FindingsState = FindingsState(), visited: Finding? = null, room: PanelRoom = PanelRoom.WHOLE, details: FindingDetails? = null, unfolded: Map<String, Boolean> = emptyMap()) = FindingsShown(found, isRunning = found == null, state, visited?.firstPlace, times, details = details, room = room, unfolded = unfolded)

    fun List<Part>.rows(key: String = "findings-list") = filterIsInstance<Rows>().filter { it.key == key }.flatMap { it.rows }.filterIsInstance<Row>()
    fun List<Part>.fold(key: String) = filterIsInstance<Fold>().single { it.key == key }
    fun List<Part>.buttons(): List<Button> = flatMap { part ->
        when (part) {
            is Buttons -> part.buttons
            is Offers -> part.buttons
            is Heading -> part.tools
            is Paragraph -> listOfNotNull(part.button)
            is Fold -> part.parts.buttons()
            is Rows -> part.rows.buttons()
            is Row -> part.tools + part.below.buttons()
            else -> emptyList()
        }
    }

    fun many(count: Int) = RuleResults(List(count) { found("Rule $it", Severity.NOTE, Span(it.toDouble(), it.toDouble())) }, ran = count)

    test("a list above graphs of a match is as high before the rules have run as after, until a person is inside it") {
        fun isFixed(room: PanelRoom = PanelRoom.SHARED, hasRules: Boolean = true, wasEnabled: Boolean = true, isInside: Boolean = false) = room.isFixed(hasRules, wasEnabled, isInside)
        isFixed() shouldBe true
        isFixed(isInside = true) shouldBe false
        isFixed(hasRules = false) shouldBe false
        isFixed(wasEnabled = false) shouldBe false
        for (room in listOf(PanelRoom.WHOLE, PanelRoom.NARROW)) isFixed(room) shouldBe false
    }

    test("findings have severity, time and text, the worst first, and ones without a time are about the whole log") {
        val parts = findingsPanel(shown())
        parts.filterIsInstance<Heading>().single().status shouldBe "1 error, 1 warning, 1 note"
        val rows = parts.rows()
        rows.map { it.title } shouldBe listOf("Early", "Whole", "Late")
        rows.map { row -> row.lines.single().run { time to until } } shouldBe listOf("10.00" to "12.50", "whole log" to "", "80.00" to "")
        rows.map { it.isCurrent } shouldBe listOf(false, false, false)
        rows[0].open shouldSend FindingAction.GoTo((rows[0].open as FindingAction.GoTo).place, null)
        (rows[0].open as FindingAction.GoTo).place.span shouldBe Span(10.0, 12.5)
    }

    test("the panel says that rules run, and is empty before anything is known") {
        findingsPanel(shown(found = null)).filterIsInstance<Heading>().single().status shouldBe "running the rules…"
        findingsPanel(shown(RuleResults())).shouldBeEmpty()
        findingsPanel(shown(RuleResults(ran = 4))).filterIsInstance<Heading>().single().status shouldBe "Nothing was found."
    }

    test("rules that could not run, and wrong rules, are troubles with the place of the mistake") {
        val wrong = SkippedRule("Half", 1, "Line 4: unknown\nmean(A, 5)\n^^^^", isMistake = true)
        val parts = findingsPanel(shown(RuleResults(skipped = listOf(wrong), ran = 1, trouble = "badlog-rules.toml: bad")))
        parts.filterIsInstance<Trouble>().map { it.text } shouldBe listOf("badlog-rules.toml: bad", "The rule “Half” is wrong. Line 4: unknown")
        parts.filterIsInstance<Trouble>().last().pointer shouldBe "mean(A, 5)\n^^^^"
        parts.filterIsInstance<Heading>().single().status shouldBe ""
    }

    test("incidents are first, their sentences are not repeated, and their other findings are folded") {
        fun of(rule: String, time: Double, severity: Severity) = Finding(rule, severity, "Arm/Output", "$rule.", time, listOf(Span(time, time + 1)), 1, "s")
        val all = listOf(of("Motor stalled", 20.0, Severity.ERROR), of("Low battery", 20.5, Severity.ERROR), of("Own rule", 90.0, Severity.WARNING))
        val incidents = RuleSet.BUILT_IN_PROVEN.incidentsIn(all)
        val parts = findingsPanel(shown(RuleResults(all, incidents = incidents, ran = 3), visited = all[0]))
        val incident = parts.rows("incidents").single()
        incident.isFramed shouldBe true
        incident.isCurrent shouldBe true
        incident.lines.map { it.isCurrent } shouldBe listOf(true, false)
        (incident.open as FindingAction.GoTo).isWhole shouldBe true
        parts.indexOfFirst { it.key == "incidents" } shouldBe parts.indexOfFirst { it is Rows }
        parts.rows().map { it.title } shouldBe listOf("Own rule")
    }

    test("above graphs a few findings are listed, two more if these are all, and the others on request") {
        findingsPanel(shown(many(7), room = PanelRoom.SHARED)).rows().size shouldBe 7
        val parts = findingsPanel(shown(many(8), room = PanelRoom.SHARED))
        parts.rows().size shouldBe 5
        parts.buttons().single { it.action == FindingAction.ListMore }.label shouldBe "Show 3 more"
        val more = findingsPanel(shown(many(400), FindingsState(listed = 300), room = PanelRoom.SHARED))
        more.rows().size shouldBe 300
        more.filterIsInstance<Rows>().single().isLong shouldBe true
        more.buttons().filter { it.label.startsWith("Show") }.map { it.label } shouldBe listOf("Show 100 more", "Show fewer")
        findingsPanel(shown(many(8), room = PanelRoom.NARROW)).rows().size shouldBe 1
        for ((room, listed) in listOf(PanelRoom.SHARED to 6, PanelRoom.NARROW to 2)) {
            val all = many(8)
            val visiting = findingsPanel(shown(all, visited = all.all[6], room = room))
            visiting.rows().size shouldBe listed
            visiting.rows().single { it.isCurrent }.title shouldBe "Rule 6"
            visiting.filterIsInstance<Rows>().single().isLong shouldBe false
        }
        val seven = many(7)
        findingsPanel(shown(seven, visited = seven.all[6], room = PanelRoom.SHARED)).rows().size shouldBe 7
        findingsPanel(shown(many(400))).rows().size shouldBe 400
    }

    test("below the visited finding are its places, what to look at next, its caveats, and other graphs") {
        val places = arrayOf(Span(10.0, 11.0), Span(30.0, 31.0))
        val often = found("Often", Severity.ERROR, *places, next = "Look at the cable.", caveats = listOf("Sampled twice a second."))
        val offer = EvidenceOffer("Voltage", listOf("V"))
        val details = FindingDetails(hasGraphs = true, offers = listOf(offer))
        val row = findingsPanel(shown(RuleResults(listOf(often), ran = 1), visited = often, details = details)).rows().single()
        row.isCurrent shouldBe true
        row.below.filterIsInstance<Paragraph>().map { it.text } shouldBe
            listOf("1 of 2: 10.00", "Often was seen.", "Next: Look at the cable.", "Sampled twice a second.")
        row.below.buttons().map { it.label to it.isEnabled } shouldBe
            listOf("Previous place" to false, "Next place" to true, "Keep" to true, "Voltage" to true)
        row.below.buttons().last().action shouldSend Action.Ask(FindingRequest.Add(offer))
        row.tools.shouldBeEmpty()
        val apart = findingsPanel(shown(RuleResults(listOf(often), ran = 1), visited = often)).rows().single()
        apart.below.shouldBeEmpty()
        apart.tools.single().action shouldSend Action.Ask(FindingRequest.Pin(often, null))
    }

    test("a search hides findings, reports their number, and shows them again") {
        val parts = findingsPanel(shown(state = FindingsState(query = "early")))
        parts.rows().map { it.title } shouldBe listOf("Early")
        val hidden = parts.filterIsInstance<Paragraph>().single { it.key == "findings-hidden" }
        hidden.text shouldBe "2 findings hidden by the search."
        hidden.button?.action shouldSend FindingAction.Search("")
        val field = parts.filterIsInstance<Field>().single()
        field.text shouldBe "early"
        field.onText("late") shouldSend FindingAction.Search("late")
        findingsPanel(shown(room = PanelRoom.SHARED)).filterIsInstance<Field>().shouldBeEmpty()
    }

    test("skipped rules are folded, with a field for each of at most five missing signals") {
        val skipped = List(8) { SkippedRule("Rule $it", 1, "no signal", isMistake = false, lacking = "signal $it") }
        val fold = findingsPanel(shown(RuleResults(skipped = skipped, ran = 2), unfolded = mapOf("findings-skipped" to true))).fold("findings-skipped")
        fold.isOpen shouldBe true
        fold.toggle shouldSend Action.Unfold("findings-skipped", false)
        val fields = fold.parts.filterIsInstance<Field>()
        fields.map { it.label } shouldBe List(5) { "“signal $it” is" }
        fields[1].onText("B") shouldSend Action.Ask(FindingRequest.Assign("signal 1", "B"))
        fold.parts.filterIsInstance<Paragraph>().size shouldBe 8
        findingsPanel(shown()).filterIsInstance<Fold>().shouldBeEmpty()
    }

    test("signals that a program can log have the lines of code for them, with the selected library") {
        val skipped = listOf("battery", "packet loss", "no such").map { SkippedRule("Rule of $it", 1, "no signal", isMistake = false, lacking = it) }
        fun parts(state: FindingsState) = findingsPanel(shown(RuleResults(skipped = skipped, ran = 2), state, unfolded = mapOf("findings-skipped" to true))).fold("findings-skipped").parts
        val first = parts(FindingsState())
        first.filterIsInstance<Code>().single().text shouldBe """SmartDashboard.putNumber("Battery Voltage", RobotController.getBatteryVoltage());"""
        val options = first.filterIsInstance<Choice>().single().options
        options.map { it.label } shouldBe listOf("WPILib", "AdvantageKit", "Epilogue", "DogLog", "Phoenix 6", "badlog")
        options.filter { it.isOn == true }.map { it.label } shouldBe listOf("WPILib")
        options[3].action shouldSend FindingAction.ShowLines(LoggingLibrary.DOGLOG)
        parts(FindingsState(library = LoggingLibrary.DOGLOG)).filterIsInstance<Code>().single().text shouldBe
            """DogLog.log("Battery Voltage", RobotController.getBatteryVoltage());"""
        first.filterIsInstance<Paragraph>().take(2).map { it.text } shouldBe listOf(
            "In robotPeriodic(), with DataLogManager.start() in the robot's constructor.",
            "“packet loss” is in the Driver Station's log: open that beside this one.",
        )
    }

    test("with a team's list, a finding has the actions for its item in the menu and below it") {
        val list = TodoList.of(emptyList(), emptyList())
        val parts = findingsPanel(FindingsShown(some, false, FindingsState(), early.firstPlace, times, todo = ListedTasks(list, "a.bag", "Ada"), details = FindingDetails(false, emptyList())))
        val row = parts.rows().first()
        row.menu.map { it.label } shouldBe listOf("Mark as done…", "Assign…", "Put on the list")
        row.menu.last().action shouldBe Action.Ask(FolderRequest.WriteTodo(taskOf(early), TodoDeed.Open))
        row.below.buttons().map { it.label } shouldBe row.menu.map { it.label }
        findingsPanel(shown()).rows().first().menu.shouldBeEmpty()
    }

    test("the differences to earlier logs are above all findings, and are drawn over them on request") {
        val parts = findingsPanel(FindingsShown(some, false, FindingsState(), null, times, differences = listOf(late)))
        val offers = parts.filterIsInstance<Offers>().single()
        offers.title shouldBe "Unlike the matches before"
        offers.buttons.single().action shouldSend Action.Ask(FindingRequest.Compare(late))
        (parts.indexOf(offers) < parts.indexOfFirst { it is Rows }) shouldBe true
    }

    test("assigned signals are listed, to be forgotten or saved") {
        val parts = findingsPanel(FindingsShown(some, false, FindingsState(), null, times, assigned = mapOf("battery" to "Volts"), room = PanelRoom.SHARED))
        parts.filterIsInstance<Paragraph>().single { it.key.startsWith("signals-chosen") }.run {
            text shouldBe "“battery” is “Volts” in this browser."
            button?.action shouldSend Action.Ask(FindingRequest.Forget("battery"))
        }
        parts.buttons().last().action shouldBe Action.Ask(FindingRequest.SaveSignals)
    }

    test("all rows have different keys, even if a hook reports the same twice") {
        val twice = RuleResults(listOf(early, found("Early", Severity.ERROR, Span(10.0, 12.5)), found("Early null 1", Severity.ERROR), late), ran = 1)
        findingsPanel(shown(twice)).rows().map { it.key }.shouldBeUnique()
    }

    test("times since the enabling of the robot are shown if known") {
        times.sinceEnabled(5.0).shouldBeNull()
        times.logged(Double.NaN) shouldBe "–"
    }
})
