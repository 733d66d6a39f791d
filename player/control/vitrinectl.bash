# Completion of vitrinectl for bash.
_vitrinectl() {
    local word=${COMP_WORDS[COMP_CWORD]} command='' i
    for ((i = 1; i < COMP_CWORD; i++)); do
        case ${COMP_WORDS[i]} in -*) ;; *) command=${COMP_WORDS[i]}; break ;; esac
    done
    case $command in
    '') mapfile -t COMPREPLY < <(compgen -W 'status why next pause resume pin remove screenshot reload --json --help' -- "$word") ;;
    pin)
        if ((COMP_CWORD > i + 1)); then
            mapfile -t COMPREPLY < <(compgen -W off -- "$word")
        else
            compopt -o filenames
            mapfile -t COMPREPLY < <(compgen -f -- "$word")
        fi
        ;;
    why | remove | screenshot)
        compopt -o filenames
        mapfile -t COMPREPLY < <(compgen -f -- "$word")
        ;;
    status) mapfile -t COMPREPLY < <(compgen -W --json -- "$word") ;;
    esac
}
complete -F _vitrinectl vitrinectl
