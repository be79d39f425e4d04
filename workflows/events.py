"""Handler for snakemake --log-handler-script: one line of JSON on standard output for each step that
begins, ends or fails, and one with the number of steps. scripts/workflow.py reads them."""
import json
import re

started = {}


def log_handler(message):
    level = message['level']
    if level == 'run_info':
        total = re.search(r'^total\s+(\d+)', message['msg'], re.M)
        if total:
            # The rule that asks for all others is none.
            print(json.dumps({'event': 'total', 'total': int(total.group(1)) - 1}), flush=True)
    elif level == 'job_info':
        started[message['jobid']] = {'rule': message['name'], 'wildcards': dict(message['wildcards']),
                                     'log': [str(path) for path in message['log']]}
        tell('begin', message['jobid'])
    elif level == 'job_finished':
        tell('end', message['jobid'])
    elif level == 'job_error':
        tell('fail', message['jobid'])


def tell(event, job):
    if job in started:
        print(json.dumps({'event': event, 'job': job, **started[job]}), flush=True)
