package badlog.page.parts

import badlog.core.recording.Severity
import badlog.page.dom.Icon
import badlog.page.pen.paint
import badlog.page.view.Palette
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.panel.Button
import badlog.viewer.panel.Buttons
import badlog.viewer.panel.Card
import badlog.viewer.panel.Cards
import badlog.viewer.panel.Cell
import badlog.viewer.panel.Check
import badlog.viewer.panel.Choice
import badlog.viewer.panel.Code
import badlog.viewer.panel.Column
import badlog.viewer.panel.Field
import badlog.viewer.panel.Fold
import badlog.viewer.panel.Heading
import badlog.viewer.panel.Line
import badlog.viewer.panel.Offers
import badlog.viewer.panel.Paragraph
import badlog.viewer.panel.Part
import badlog.viewer.panel.PartIcon
import badlog.viewer.panel.Picture
import badlog.viewer.panel.Preview
import badlog.viewer.panel.Row
import badlog.viewer.panel.Rows
import badlog.viewer.panel.Table
import badlog.viewer.panel.TableRow
import badlog.viewer.panel.Tone
import badlog.viewer.panel.Trouble
import badlog.viewer.panel.Value
import badlog.viewer.state.Action
import badlog.viewer.text.word
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLInputElement
import org.w3c.dom.events.Event

/**
 * Makes nodes from the parts of a panel; the class of each is the first word of its key. Pictures have the colors of [palette], and a
 * person's actions go to [send].
 */
internal class PartNodes(private val palette: Palette, private val send: (Action) -> Unit) {
    private val shared = ArrayList<List<String>>()

    /** The nodes of buttons, which stay the same while values beside them change with each step of the cursor. */
    private val buttons = js("new WeakMap()")

    /** The last row and node for each key of a row, by table. Comparing rows costs less than comparing their nodes. */
    private val known = HashMap<String, HashMap<String, Pair<TableRow, Node>>>()

    /** Returns the [parts] of a panel as nodes. */
    fun of(parts: List<Part>): List<Node> {
        shared.clear()
        return nodesOf(parts)
    }

    private fun nodesOf(parts: List<Part>) = parts.map(::of)

    private fun of(part: Part): Node = when (part) {
        is Heading -> heading(part)
        is Paragraph -> paragraph(part)
        is Trouble -> trouble(part)
        is Buttons -> Node("div", part.className, key = part.key, children = part.buttons.map(::textButton))
        is Offers -> offers(part)
        is Choice -> choice(part)
        is Code -> code(part)
        is Field -> field(part)
        is Fold -> fold(part)
        is Rows -> rows(part)
        is Row -> row(part)
        is Value -> value(part)
        is Table -> table(part)
        is Picture -> picture(part)
        is Cards -> Node("div", part.className, key = part.key, children = part.cards.map(::card))
        is Card -> card(part)
    }

    private fun card(card: Card): Node {
        val texts = listOf("b" to card.title, "strong" to card.headline) + card.lines.map { "span" to it }
        val children = texts.filter { it.second.isNotEmpty() }.map { (tag, text) -> Node(tag, text = text) }
        val look = "big-card has-${card.severity?.word}" + if (card.isLarge) " is-large" else ""
        val open = card.open ?: return Node("div", look, key = card.key, children = children)
        val attributes = mapOf("title" to card.hint, "data-path" to card.key)
        return Node("button", look, key = card.key, attributes = attributes, press = { send(open) }, children = children)
    }

    private fun heading(heading: Heading) = Node(
        "header",
        "graph-head",
        key = heading.key,
        children = listOf(
            Node("h2", "findings-title", heading.title),
            Node("span", "unit", heading.status, attributes = mapOf("role" to "status")),
        ) + heading.tools.map(::iconButton),
    )

    private fun paragraph(paragraph: Paragraph): Node {
        val tag = if (paragraph.tone == Tone.TITLE) "h3" else "p"
        val button = paragraph.button ?: return Node(tag, paragraph.className, paragraph.text, paragraph.key)
        val parts = listOf(Node("span", text = "${paragraph.text} "), textButton(button))
        return Node("p", paragraph.className, key = paragraph.key, children = parts)
    }

    private fun trouble(trouble: Trouble): Node {
        val pointer = if (trouble.pointer.isEmpty()) null else Node("pre", "pointer", trouble.pointer)
        val text = listOfNotNull(Node("span", text = trouble.text), Node("span", "problem-place", trouble.place), pointer)
        val severity = Node("span", "severity is-${trouble.word}", trouble.word)
        val parts = listOf(severity, Node("div", "problem-text", children = text))
        return Node("div", "problem", key = trouble.key, children = parts)
    }

    private fun offers(offers: Offers): Node {
        val list = Node("ul", children = offers.buttons.map { Node("li", children = listOf(textButton(it))) })
        val parts = listOf(Node("h3", text = offers.title), list)
        return Node("section", offers.className, key = offers.key, attributes = mapOf("aria-label" to offers.title), children = parts)
    }

    private fun code(code: Code): Node {
        // Anything that scrolls must react to keys.
        val attributes = mapOf("tabindex" to "0", "role" to "region", "aria-label" to code.name)
        return Node("pre", code.className, code.text, code.key, attributes)
    }

    private fun choice(choice: Choice): Node {
        val options = choice.options.map(::textButton)
        val named = mapOf("role" to "group", "aria-label" to choice.name)
        val name = Node("span", text = "${choice.name} ", attributes = mapOf("aria-hidden" to "true"))
        return Node("div", "choice ${choice.className}", key = choice.key, attributes = named, children = listOf(name) + options)
    }

    private fun field(field: Field): Node {
        val changed = { event: Event ->
            val input = event.target.unsafeCast<HTMLInputElement>()
            val text = input.value
            if ((text.isNotEmpty() || field.isSearch) && field.isValid(text)) send(field.onText(text))
            // The attribute has the text that counts.
            if (!field.isSearch && field.suggestions.isEmpty()) input.value = input.getAttribute("value").orEmpty()
        }
        // Fields with the same suggestions share their list: there may be thousands.
        val index = shared.indexOfFirst { it === field.suggestions }
        val list = if (index >= 0) index else shared.size
        val suggested = if (field.suggestions.isEmpty()) emptyMap() else mapOf("list" to "suggestions-$list", "placeholder" to "a topic…")
        val attributes = mapOf("title" to field.hint, "value" to field.text) + suggested
        val input = Node("input", attributes = attributes, on = mapOf((if (field.isSearch) "input" else "change") to changed))
        val parts = listOf(Node("span", text = "${field.label} "), input)
        val isFirst = field.suggestions.isNotEmpty() && index < 0
        if (isFirst) shared += field.suggestions
        val all = if (isFirst) parts + suggestions(field.suggestions, list) else parts
        return Node("label", field.className, key = field.key, children = all)
    }

    private fun suggestions(names: List<String>, list: Int): Node {
        val options = names.map { Node("option", key = it, attributes = mapOf("value" to it)) }
        return Node("datalist", attributes = mapOf("id" to "suggestions-$list"), children = options)
    }

    private fun fold(fold: Fold): Node {
        // The state decides whether it is open, not the browser.
        val toggle = { event: Event ->
            event.preventDefault()
            send(fold.toggle)
        }
        val title = Node("summary", text = fold.title, on = mapOf("click" to toggle))
        val parts = listOf(title) + if (fold.isOpen) nodesOf(fold.parts) else emptyList()
        val className = fold.className + fold.severity?.let { " has-${it.word}" }.orEmpty()
        return Node("details", className, key = fold.key, attributes = mapOf("open" to "".takeIf { fold.isOpen }), children = parts)
    }

    private fun rows(rows: Rows): Node {
        // Anything that scrolls must react to keys.
        val attributes = mapOf("aria-label" to rows.name, "tabindex" to "0".takeIf { rows.isLong })
        val className = rows.className + if (rows.isLong) " is-long" else ""
        return Node("ol", className, key = rows.key, attributes = attributes, children = rows.rows.map(::item))
    }

    private fun item(part: Part): Node =
        if (part is Row || part is Value) of(part) else Node("li", key = part.key, children = listOf(of(part)))

    private fun value(value: Value): Node {
        val name = Node("span", "cut-name", children = listOf(Node("bdi", text = value.name, hint = { value.name })))
        val text = value.field?.let(::field) ?: Node("bdi", "value-text", value.text, hint = value.exact)
        val tools = value.tools.map { iconButton(it, "pin") }
        return Node(
            "li",
            value.className + if (value.isMarked) " is-marked" else "",
            key = value.key,
            children = listOfNotNull(value.color?.let(::swatch), name, text) + tools,
        )
    }

    private fun row(row: Row): Node {
        val badge = listOfNotNull(row.check?.let(::check), row.severity?.let(::badge))
        val parts = if (row.isFramed) framed(row) else plain(row)
        return Node(
            "li",
            row.className,
            key = row.key,
            attributes = mapOf("aria-current" to "true".takeIf { row.isCurrent }),
            on = pressed(row.open),
            children = badge + parts + row.tools.map { iconButton(it, "pin") },
        )
    }

    /** Makes a press on a row, but not on its buttons, have the effect [open]. */
    private fun pressed(open: Action?) = mapOf(
        "click" to { event: Event -> if (event.target.asDynamic().closest("button, a, input") == null) open?.let(send) ?: Unit },
    )

    private fun badge(severity: Severity) = Node("span", "severity is-${severity.word}", severity.word)

    private fun table(table: Table): Node {
        val checks = listOf(Node("td", "checks")).filter { table.rows.any { it.checks.isNotEmpty() } }
        val titles = table.columns.map { column ->
            val order = column.isDescending?.let { if (it) "descending" else "ascending" }
            val arrow = column.isDescending?.let { if (it) " ↓" else " ↑" }.orEmpty()
            val sort = column.sort?.let { textButton(Button(column.title + arrow, it)) }
            val attributes = mapOf("title" to column.hint.ifEmpty { null }, "aria-sort" to order)
            Node("th", column.look, column.title.takeIf { sort == null }, column.key, attributes, children = listOfNotNull(sort))
        }
        val rows = known.getOrPut(table.key + checks.size + titles.joinToString { it.className }) { HashMap() }
        val body = table.groups.flatMap { group ->
            // Its text reaches over the empty cells beside it: narrow screens hide some columns.
            val span = mapOf("scope" to "rowgroup")
            val texts = listOf(Node("span", text = group.title), Node("span", "unit", group.count))
            val title = Node("tr", "row-group", key = group.title, children = listOf(Node("th", attributes = span, children = texts)))
            listOf(title).filter { group.title.isNotEmpty() } + group.rows.map { row ->
                val last = rows[row.key]
                if (last?.first == row) last.second else tableRow(row, table.columns, checks).also { rows[row.key] = row to it }
            }
        }
        rows.keys.retainAll(table.rows.mapTo(HashSet()) { it.key })
        return Node(
            "table",
            table.className,
            key = table.key,
            attributes = mapOf("aria-label" to table.name.ifEmpty { null }),
            children = listOf(Node("thead", children = listOf(Node("tr", children = checks + titles))), Node("tbody", children = body)),
        )
    }

    private fun tableRow(row: TableRow, columns: List<Column>, checks: List<Node>): Node {
        val cells = columns.mapIndexed { i, column ->
            val cells = row.cells[i]
            val only = cells.singleOrNull()
            if (i == 0) {
                val subject = cells.map { cell(it, "cut-name") }
                Node("th", column.look, key = column.key, attributes = mapOf("scope" to "row"), children = subject)
            } else if (only == null || only.severity != null || only.share != null || only.preview != null || only.open != null) {
                Node("td", column.look, key = column.key, children = cells.map(::cell))
            } else {
                Node("td", column.look, only.text, column.key, mapOf("title" to only.ownHint))
            }
        }
        return Node(
            "tr",
            if (row.isMuted) "is-gray" else "",
            key = row.key,
            attributes = mapOf("data-path" to row.key.ifEmpty { null }),
            on = pressed(row.open),
            children = checks.map { Node("td", "checks", children = row.checks.map(::check)) } + cells,
        )
    }

    private fun swatch(color: Int) = Node("span", "swatch line-${color % LINE_COLORS}")

    private fun check(check: Check): Node {
        val attributes = mapOf("type" to "checkbox", "aria-label" to check.label, "checked" to "".takeIf { check.isOn })
        return Node("input", attributes = attributes, on = mapOf("change" to { _: Event -> send(check.action) }))
    }

    private fun cell(cell: Cell, className: String = ""): Node {
        val bar = cell.share?.let {
            Node("progress", "is-${cell.severity?.word}", attributes = mapOf("value" to "$it", "aria-hidden" to "true"))
        }
        cell.preview?.let { return curve(it) }
        // Within its own direction, a slash at the beginning of a name stays there.
        val text = cell.open?.let { textButton(Button(cell.text, it, hint = cell.hint), cell.isUnfolded) }
            ?: Node("span", className, attributes = mapOf("title" to cell.ownHint), children = listOf(Node("bdi", text = cell.text)))
        return Node(
            "div",
            children =
            listOfNotNull(cell.color?.let(::swatch), bar ?: cell.severity?.let(::badge), text) + cell.tools.map(::iconButton),
        )
    }

    private fun curve(preview: Preview): Node {
        val path = preview.lines.joinToString("") { line ->
            "M" + line.indices.joinToString(" ") { "${(line[it] * if (it % 2 == 0) CURVE_WIDTH else CURVE_HEIGHT).toInt()}" }
        }
        val place = mapOf("class" to "preview", "viewBox" to "0 -1 $CURVE_WIDTH ${CURVE_HEIGHT + 2}", "aria-hidden" to "true")
        val shape = mapOf("preserveAspectRatio" to "none")
        return Node("svg", attributes = place + shape, children = listOf(Node("path", attributes = mapOf("d" to path))))
    }

    private val Cell.ownHint get() = hint.takeIf { it != text }

    /** The classes of a column, by which the style sheet arranges cards. */
    private val Column.look: String get() = key + (if (isNumber) " is-number" else "") + if (isMinor) " is-minor" else ""

    private fun framed(row: Row): List<Node> {
        val lines = row.lines.mapIndexed { i, line ->
            Node("p", key = "line $i", children = listOf(time(line.time, line), Node("span", text = line.text)))
        }
        return listOf(Node("div", "incident-text", children = lines + nodesOf(row.below)))
    }

    private fun plain(row: Row): List<Node> {
        val line = row.lines.firstOrNull()
        val until = line?.until.orEmpty()
        val time = line?.let { time(if (until.isEmpty()) it.time else "${it.time} – $until", it) }
        val title = listOf(Node("span", "finding-source", row.title)).filter { row.title.isNotEmpty() }
        val texts = title + row.lines.map { Node("span", text = it.text) }
        val count = if (row.count.isEmpty()) null else Node("span", "unit finding-count", row.count)
        return listOfNotNull(time, Node("span", "finding-text", children = texts + nodesOf(row.below)), count)
    }

    private fun time(text: String, line: Line): Node {
        val open = line.open ?: return Node("span", "finding-whole", text)
        return Node("button", "event-go", text, attributes = mapOf("title" to line.hint), press = { send(open) })
    }

    private fun textButton(button: Button, isUnfolded: Boolean? = null): Node {
        val hint = button.hint.takeIf { it != button.label }
        val attributes = mapOf("title" to hint, "aria-expanded" to isUnfolded?.toString()) + button.state
        return Node("button", "text-button", button.label, attributes = attributes, press = { send(button.action) })
    }

    private fun iconButton(button: Button, className: String = ""): Node =
        buttons.get(button).unsafeCast<Node?>() ?: madeButton(button, className).also { buttons.set(button, it) }

    private fun madeButton(button: Button, className: String): Node {
        val attributes = mapOf("title" to button.hint, "aria-label" to button.hint) + button.state
        val word = button.label.takeIf { button.icon == null }
        val names = if (word == null) "icon-button $className".trim() else "text-button"
        return Node("button", names, word, button.label, attributes = attributes, icon = button.icon?.icon, press = { send(button.action) })
    }

    private val Button.state get() = mapOf("disabled" to "".takeIf { !isEnabled }, "aria-pressed" to isOn?.toString())

    private fun picture(picture: Picture) = Node(
        "canvas",
        picture.className,
        key = picture.key,
        attributes = mapOf("role" to "img", "aria-label" to picture.name),
        draw = { canvas ->
            canvas.unsafeCast<HTMLCanvasElement>().paint(picture.height) { pen, width -> picture.draw(pen, width, palette.colors) }
        },
    )

    private val Part.className: String get() = key.substringBefore(' ')
}

private val PartIcon.icon: Icon
    get() = when (this) {
        PartIcon.PREVIOUS -> Icon.BACK
        PartIcon.NEXT -> Icon.CHEVRON
        PartIcon.AGAIN -> Icon.RESET
        PartIcon.PIN -> Icon.PIN
        PartIcon.ADD -> Icon.PLUS
        PartIcon.REMOVE -> Icon.MINUS
        PartIcon.NOTE -> Icon.NOTE
        PartIcon.ZOOM -> Icon.SEARCH
        PartIcon.CLOSE -> Icon.CLOSE
        PartIcon.COPY, PartIcon.DONE, PartIcon.PERSON -> Icon.LIST
        PartIcon.UNDONE -> Icon.UNDO
        PartIcon.HISTOGRAM -> Icon.BARS
    }

/** The width and height of the square in which previews are drawn, before they are stretched. */
private const val CURVE_WIDTH = 192
private const val CURVE_HEIGHT = 100
